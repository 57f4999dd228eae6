namespace isolux::ui {}
int main() { return 0; }
