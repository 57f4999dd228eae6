<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Replace the preset “%1”?</source>
        <translation>Die Vorlage „%1“ ersetzen?</translation>
    </message>
    <message>
        <source>Graphics memory</source>
        <translation>Grafikspeicher</translation>
    </message>
    <message>
        <source>Volume storage on the GPU</source>
        <translation>Volumenspeicherung auf der Grafikkarte</translation>
    </message>
    <message>
        <source>CPU threads for lighting</source>
        <translation>CPU-Threads für die Beleuchtung</translation>
    </message>
    <message>
        <source>Lower resolution in motion</source>
        <translation>Geringere Auflösung bei Bewegung</translation>
    </message>
    <message>
        <source>Frame time in motion</source>
        <translation>Bildzeit bei Bewegung</translation>
    </message>
    <message>
        <source>Ray casting device</source>
        <translation>Gerät für das Ray-Casting</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Standard: %1</translation>
    </message>
    <message>
        <source> big endian</source>
        <translation> Big-Endian</translation>
    </message>
    <message>
        <source>, header %1 bytes</source>
        <translation>, Kopf %1 Byte</translation>
    </message>
    <message>
        <source>unknown image format; use .png or .exr</source>
        <translation>unbekanntes Bildformat; .png oder .exr verwenden</translation>
    </message>
    <message>
        <source>%1 phantom</source>
        <translation>Phantom %1</translation>
    </message>
    <message>
        <source>Turn environment</source>
        <translation>Umgebung drehen</translation>
    </message>
    <message>
        <source>Choose environment map</source>
        <translation>Umgebungsbild wählen</translation>
    </message>
    <message>
        <source>Choose light</source>
        <translation>Licht wählen</translation>
    </message>
    <message>
        <source>a large soft light from the upper left, a weak light from the right and a rim light from behind</source>
        <translation>ein großes weiches Licht von links oben, ein schwaches von rechts und ein Kantenlicht von hinten</translation>
    </message>
    <message>
        <source>daylight through one window at the left of a room</source>
        <translation>Tageslicht durch ein Fenster links im Raum</translation>
    </message>
    <message>
        <source>a cloudy sky: soft light from above</source>
        <translation>bedeckter Himmel: weiches Licht von oben</translation>
    </message>
    <message>
        <source>a low warm sun at the left under a blue sky</source>
        <translation>tiefe, warme Sonne links unter blauem Himmel</translation>
    </message>
    <message>
        <source>%1 is out of range (%2 … %3)</source>
        <translation>%1 liegt außerhalb des Bereichs (%2 … %3)</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Byte</translation>
    </message>
    <message>
        <source>1 measurement</source>
        <translation>1 Messung</translation>
    </message>
    <message>
        <source>%1 measurements</source>
        <translation>%1 Messungen</translation>
    </message>
    <message>
        <source>Single colour</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>nicht gemessen: %1</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>Hinweis: %1</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>Light stopped</source>
        <translation>Licht angehalten</translation>
    </message>
    <message>
        <source>Light: preparing…</source>
        <translation>Licht: wird vorbereitet …</translation>
    </message>
    <message>
        <source>Light: %1</source>
        <translation>Licht: %1</translation>
    </message>
    <message>
        <source>Light paused at %1</source>
        <translation>Licht pausiert bei %1</translation>
    </message>
    <message>
        <source>Light complete</source>
        <translation>Licht fertig</translation>
    </message>
    <message>
        <source>No light</source>
        <translation>Kein Licht</translation>
    </message>
    <message>
        <source>Baked: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>%1 texels lit, %2 million rays in %3</source>
        <translation>%1 Texel beleuchtet, %2 Millionen Strahlen in %3</translation>
    </message>
    <message>
        <source>%1 million rays/s</source>
        <translation>%1 Mio. Strahlen/s</translation>
    </message>
    <message>
        <source>%1 thousand rays/s</source>
        <translation>%1 Tsd. Strahlen/s</translation>
    </message>
    <message>
        <source>%1 rays/s</source>
        <translation>%1 Strahlen/s</translation>
    </message>
    <message>
        <source>light %1 complete</source>
        <translation>Licht zu %1 fertig</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Farbskala</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Strömung</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Lichtquellen</translation>
    </message>
    <message>
        <source>Global illumination</source>
        <translation>Globale Beleuchtung</translation>
    </message>
    <message>
        <source>Texture and fog</source>
        <translation>Textur und Nebel</translation>
    </message>
    <message>
        <source>Hit finding</source>
        <translation>Treffersuche</translation>
    </message>
    <message>
        <source>Derivatives</source>
        <translation>Ableitungen</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Environment map</source>
        <translation>Umgebungsbild</translation>
    </message>
    <message>
        <source>Sky colour</source>
        <translation>Himmelsfarbe</translation>
    </message>
    <message>
        <source>Built-in light</source>
        <translation>Eingebautes Licht</translation>
    </message>
    <message>
        <source>Show as background</source>
        <translation>Als Hintergrund zeigen</translation>
    </message>
    <message>
        <source>Light %1</source>
        <translation>Lichtquelle %1</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Isosurface %1</source>
        <translation>Isofläche %1</translation>
    </message>
    <message>
        <source>Colour source</source>
        <translation>Farbquelle</translation>
    </message>
    <message>
        <source>SH order</source>
        <translation>SH-Ordnung</translation>
    </message>
    <message>
        <source>SH window</source>
        <translation>SH-Fenster</translation>
    </message>
    <message>
        <source>Colours of κ₁ and κ₂</source>
        <translation>Farben von κ₁ und κ₂</translation>
    </message>
    <message>
        <source>, %1 × %1 rays per pixel</source>
        <translation>, %1 × %1 Strahlen je Pixel</translation>
    </message>
    <message>
        <source> (tilted by %1°)</source>
        <translation> (um %1° gekippt)</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Angiography</source>
        <translation>Angiographie</translation>
    </message>
    <message>
        <source>Axial slice</source>
        <translation>Axiale Schicht</translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation>Koronale Schicht</translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation>Sagittale Schicht</translation>
    </message>
    <message>
        <source>Pin: click on the surface</source>
        <translation>Pin: auf die Oberfläche klicken</translation>
    </message>
    <message>
        <source>Distance: click two points; Shift adds more</source>
        <translation>Abstand: zwei Punkte anklicken; Umschalt fügt weitere hinzu</translation>
    </message>
    <message>
        <source>Geodesic distance: click two points; Shift adds more</source>
        <translation>Geodätischer Abstand: zwei Punkte anklicken; Umschalt fügt weitere hinzu</translation>
    </message>
    <message>
        <source>Angle: click three points, the vertex second; Shift at the third measures between two lines</source>
        <translation>Winkel: drei Punkte anklicken, den Scheitel als zweiten; Umschalt beim dritten misst zwischen zwei Geraden</translation>
    </message>
    <message>
        <source>Circle: click three points</source>
        <translation>Kreis: drei Punkte anklicken</translation>
    </message>
    <message>
        <source>Thickness: click on the surface</source>
        <translation>Dicke: auf die Oberfläche klicken</translation>
    </message>
    <message>
        <source>Piece: click on a piece</source>
        <translation>Teil: auf ein Teil klicken</translation>
    </message>
    <message>
        <source>Preparing the volume (%1): %2 %; a substitute field is shown</source>
        <translation>Volumen wird vorbereitet (%1): %2 %; gezeigt wird ein Ersatzfeld</translation>
    </message>
    <message>
        <source>Loading: %1 % of the image is missing</source>
        <translation>Laden: %1 % des Bildes fehlen</translation>
    </message>
    <message>
        <source>%1 % of the image is missing; raise Graphics memory (memory.gpu_budget_mb)</source>
        <translation>%1 % des Bildes fehlen; Grafikspeicher (memory.gpu_budget_mb) erhöhen</translation>
    </message>
    <message>
        <source>not enough memory for this image</source>
        <translation>nicht genug Speicher für dieses Bild</translation>
    </message>
    <message>
        <source>internal error: %1</source>
        <translation>interner Fehler: %1</translation>
    </message>
    <message>
        <source>internal error</source>
        <translation>interner Fehler</translation>
    </message>
    <message>
        <source>Isolux requires OpenGL 4.5. `isolux doctor` lists what this computer supports.</source>
        <translation>Isolux benötigt OpenGL 4.5. `isolux doctor` zeigt, was dieser Rechner unterstützt.</translation>
    </message>
    <message>
        <source>To try again, undo the last step or change a setting.</source>
        <translation>Zum erneuten Versuch den letzten Schritt rückgängig machen oder eine Einstellung ändern.</translation>
    </message>
    <message>
        <source>Open a volume with Ctrl+O, or drop a file or folder here</source>
        <translation>Ein Volumen mit Strg+O öffnen oder eine Datei oder einen Ordner hierher ziehen</translation>
    </message>
    <message>
        <source>Isolux session (*.isolux)</source>
        <translation>Isolux-Sitzung (*.isolux)</translation>
    </message>
    <message>
        <source>Isolux recording (*.jsonl)</source>
        <translation>Isolux-Aufzeichnung (*.jsonl)</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Raw voxels (*.raw *.bin *.img *.dat)</source>
        <translation>Rohe Voxel (*.raw *.bin *.img *.dat)</translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json)</source>
        <translation>Markups für 3D Slicer (*.mrk.json)</translation>
    </message>
    <message>
        <source>Table of measured values (*.csv)</source>
        <translation>Tabelle der Messwerte (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>&amp;Pin</translation>
    </message>
    <message>
        <source>Mark a point on the surface: position, value, curvature, edge</source>
        <translation>Einen Punkt der Oberfläche markieren: Position, Wert, Krümmung, Kante</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Abstand</translation>
    </message>
    <message>
        <source>Measure straight from point to point</source>
        <translation>Gerade von Punkt zu Punkt messen</translation>
    </message>
    <message>
        <source>Geode&amp;sic distance</source>
        <translation>Geo&amp;dätischer Abstand</translation>
    </message>
    <message>
        <source>Measure the shortest path found along the surface</source>
        <translation>Den kürzesten gefundenen Weg entlang der Oberfläche messen</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>Measure at the second of three points, or between two lines</source>
        <translation>Am zweiten von drei Punkten oder zwischen zwei Geraden messen</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>&amp;Kreis</translation>
    </message>
    <message>
        <source>Measure radius and centre of a circle through three points</source>
        <translation>Radius und Mittelpunkt eines Kreises durch drei Punkte messen</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>Di&amp;cke</translation>
    </message>
    <message>
        <source>Measure from the surface through the inside</source>
        <translation>Von der Oberfläche durch das Innere messen</translation>
    </message>
    <message>
        <source>Pi&amp;ece</source>
        <translation>&amp;Teil</translation>
    </message>
    <message>
        <source>Measure volume and area of a piece (connected component)</source>
        <translation>Volumen und Fläche eines Teils (zusammenhängende Komponente) messen</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>anonymous</source>
        <translation>anonym</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Move crosshair</source>
        <translation>Fadenkreuz bewegen</translation>
    </message>
    <message>
        <source>Add isosurface at this value, %1</source>
        <translation>Isofläche bei diesem Wert hinzufügen, %1</translation>
    </message>
    <message>
        <source>Add isosurface</source>
        <translation>Isofläche hinzufügen</translation>
    </message>
    <message>
        <source>Change window level and width</source>
        <translation>Fenstermitte und -breite ändern</translation>
    </message>
    <message>
        <source>Window level and width</source>
        <translation>Fenstermitte und -breite</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Schnitt %1</translation>
    </message>
    <message>
        <source>Oblique…</source>
        <translation>Schräg …</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Dicke Schicht (Slab)</translation>
    </message>
    <message>
        <source>Change slab</source>
        <translation>Dicke Schicht ändern</translation>
    </message>
    <message>
        <source>None (plane only)</source>
        <translation>Keine (nur die Ebene)</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Maximum (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>Minimum (MinIP)</translation>
    </message>
    <message>
        <source>Convention</source>
        <translation>Konvention</translation>
    </message>
    <message>
        <source>Radiological: the patient&apos;s right on the left</source>
        <translation>Radiologisch: rechte Seite des Patienten links</translation>
    </message>
    <message>
        <source>Neurological: the patient&apos;s left on the left</source>
        <translation>Neurologisch: linke Seite des Patienten links</translation>
    </message>
    <message>
        <source>Change convention</source>
        <translation>Konvention ändern</translation>
    </message>
    <message>
        <source>Isocontours</source>
        <translation>Isokonturen</translation>
    </message>
    <message>
        <source>Change isocontours</source>
        <translation>Isokonturen ändern</translation>
    </message>
    <message>
        <source>Show the whole slice</source>
        <translation>Ganze Schicht zeigen</translation>
    </message>
    <message>
        <source>&amp;3-D view</source>
        <translation>&amp;3D-Ansicht</translation>
    </message>
    <message>
        <source>Show the 3-D view without slices</source>
        <translation>Die 3D-Ansicht ohne Schichten zeigen</translation>
    </message>
    <message>
        <source>3-D view and &amp;slices</source>
        <translation>3D-Ansicht und &amp;Schichten</translation>
    </message>
    <message>
        <source>Show axial, coronal and sagittal slices next to the 3-D view</source>
        <translation>Axiale, koronale und sagittale Schicht neben der 3D-Ansicht zeigen</translation>
    </message>
    <message>
        <source>Slices &amp;alone</source>
        <translation>&amp;Nur Schichten</translation>
    </message>
    <message>
        <source>Show the three slices without the 3-D view</source>
        <translation>Die drei Schichten ohne die 3D-Ansicht zeigen</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>unbounded</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>depth error ≤ %1 mm</source>
        <translation>Tiefenfehler ≤ %1 mm</translation>
    </message>
    <message>
        <source>depth error ≤ %1 voxels</source>
        <translation>Tiefenfehler ≤ %1 Voxel</translation>
    </message>
    <message>
        <source>missed pixels ≤ %1 %</source>
        <translation>verfehlte Pixel ≤ %1 %</translation>
    </message>
    <message>
        <source>normal error ≤ %1°</source>
        <translation>Normalenfehler ≤ %1°</translation>
    </message>
    <message>
        <source>curvature error ≤ %1 %</source>
        <translation>Krümmungsfehler ≤ %1 %</translation>
    </message>
    <message>
        <source>light error ≤ %1 %</source>
        <translation>Lichtfehler ≤ %1 %</translation>
    </message>
    <message>
        <source>%1 % of pixels uncertain</source>
        <translation>%1 % der Pixel unsicher</translation>
    </message>
    <message>
        <source>Nothing visible · %1</source>
        <translation>Nichts sichtbar · %1</translation>
    </message>
    <message>
        <source>No certain pixels · %1</source>
        <translation>Keine sicheren Pixel · %1</translation>
    </message>
    <message>
        <source>Depth ± %1</source>
        <translation>Tiefe ± %1</translation>
    </message>
    <message>
        <source>normal ± %1</source>
        <translation>Normale ± %1</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>curvature ± %1</source>
        <translation>Krümmung ± %1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>light ± %1</source>
        <translation>Licht ± %1</translation>
    </message>
    <message>
        <source>mm (depth)</source>
        <translation>mm (Tiefe)</translation>
    </message>
    <message>
        <source>voxels (depth)</source>
        <translation>Voxel (Tiefe)</translation>
    </message>
    <message>
        <source>% (missed pixels)</source>
        <translation>% (verfehlte Pixel)</translation>
    </message>
    <message>
        <source>degrees (normals)</source>
        <translation>Grad (Normalen)</translation>
    </message>
    <message>
        <source>% (curvature)</source>
        <translation>% (Krümmung)</translation>
    </message>
    <message>
        <source>% (light)</source>
        <translation>% (Licht)</translation>
    </message>
    <message>
        <source>The current settings already meet this.</source>
        <translation>Die aktuellen Einstellungen reichen dafür.</translation>
    </message>
    <message>
        <source>Render time about %1 ms; %2</source>
        <translation>Renderzeit etwa %1 ms; %2</translation>
    </message>
    <message>
        <source>This image uses no baked light; no settings to choose</source>
        <translation>Dieses Bild verwendet kein gespeichertes Licht; keine Einstellungen zu wählen</translation>
    </message>
    <message>
        <source>This image uses no significant curvature; no settings to choose</source>
        <translation>Dieses Bild verwendet keine signifikante Krümmung; keine Einstellungen zu wählen</translation>
    </message>
    <message>
        <source>This image has no such error; no settings to choose</source>
        <translation>Dieses Bild hat keinen solchen Fehler; keine Einstellungen zu wählen</translation>
    </message>
    <message>
        <source>The first isosurface is not visible; no settings to choose</source>
        <translation>Die erste Isofläche ist nicht sichtbar; keine Einstellungen zu wählen</translation>
    </message>
    <message>
        <source>no missed pixels</source>
        <translation>keine verfehlten Pixel</translation>
    </message>
    <message>
        <source>Depth ± %1 (noise, discretisation)</source>
        <translation>Tiefe ± %1 (Rauschen, Diskretisierung)</translation>
    </message>
    <message>
        <source>rounding ± %1</source>
        <translation>Rundung ± %1</translation>
    </message>
    <message>
        <source>Error bounds of the visible surface. Noise and discretisation: against the object itself. Rounding: against the same view in double precision.
These bounds hold for 99 % of visible pixels (light: %2 %).
A pixel is uncertain if rounding may change the surface that it shows, for example along edges.
Computed with one ray through the centre of each pixel, %1 pixels.</source>
        <translation>Fehlerschranken der sichtbaren Fläche. Rauschen und Diskretisierung: gegenüber dem Objekt selbst. Rundung: gegenüber derselben Ansicht in doppelter Genauigkeit.
Diese Schranken gelten für 99 % der sichtbaren Pixel (Licht: %2 %).
Ein Pixel ist unsicher, wenn Rundung die gezeigte Fläche ändern kann, etwa an Kanten.
Berechnet mit einem Strahl durch die Mitte jedes Pixels, %1 Pixel.</translation>
    </message>
    <message>
        <source>Noise turns a typical normal by up to %1°.</source>
        <translation>Rauschen dreht eine typische Normale um bis zu %1°.</translation>
    </message>
    <message>
        <source>Light computation stopped at %1</source>
        <translation>Lichtberechnung bei %1 angehalten</translation>
    </message>
    <message>
        <source>Light computation paused at %1</source>
        <translation>Lichtberechnung bei %1 pausiert</translation>
    </message>
    <message>
        <source>Light computation starts soon</source>
        <translation>Die Lichtberechnung beginnt gleich</translation>
    </message>
    <message>
        <source>Computing light: %1, %2 left</source>
        <translation>Licht wird berechnet: %1, noch %2</translation>
    </message>
    <message>
        <source>Computing light: %1</source>
        <translation>Licht wird berechnet: %1</translation>
    </message>
    <message>
        <source>Rotatable</source>
        <translation>Drehbar</translation>
    </message>
    <message>
        <source>Image display</source>
        <translation>Bildanzeige</translation>
    </message>
    <message>
        <source>OpenGL of the window does not work</source>
        <translation>das OpenGL des Fensters arbeitet nicht</translation>
    </message>
    <message>
        <source>set by window.canvas; %1</source>
        <translation>von window.canvas vorgegeben; %1</translation>
    </message>
    <message>
        <source>%1: textures take %2 ms, pixels %3 ms</source>
        <translation>%1: Texturen brauchen %2 ms, Pixel %3 ms</translation>
    </message>
    <message>
        <source>set by window.canvas</source>
        <translation>von window.canvas vorgegeben</translation>
    </message>
    <message>
        <source>window.canvas takes effect at the next start</source>
        <translation>window.canvas wirkt ab dem nächsten Start</translation>
    </message>
    <message>
        <source>the window system offers no OpenGL</source>
        <translation>das Fenstersystem bietet kein OpenGL</translation>
    </message>
    <message>
        <source>images stay on the graphics card as textures (%1)</source>
        <translation>Bilder bleiben als Texturen auf der Grafikkarte (%1)</translation>
    </message>
    <message>
        <source>images are copied to main memory (%1)</source>
        <translation>Bilder werden in den Hauptspeicher kopiert (%1)</translation>
    </message>
    <message>
        <source>the studio over a black floor</source>
        <translation>das Studio über einem schwarzen Boden</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Choose an environment map</source>
        <translation>Umgebungsbild wählen</translation>
    </message>
    <message>
        <source>Environment maps (*.hdr *.exr);;Images (*.hdr *.exr *.png *.jpg *.jpeg *.tif *.tiff);;All files (*)</source>
        <translation>Umgebungsbilder (*.hdr *.exr);;Bilder (*.hdr *.exr *.png *.jpg *.jpeg *.tif *.tiff);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Rotation about the vertical axis, counterclockwise from above</source>
        <translation>Drehung um die senkrechte Achse, von oben gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhenwinkel</translation>
    </message>
    <message>
        <source>Height of the environment map’s centre above the horizon</source>
        <translation>Höhe der Mitte des Umgebungsbildes über dem Horizont</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Rotation about the direction of the environment map’s centre</source>
        <translation>Drehung um die Richtung der Mitte des Umgebungsbildes</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Isosurfaces</source>
        <translation>Isoflächen</translation>
    </message>
    <message>
        <source>Add light</source>
        <translation>Lichtquelle hinzufügen</translation>
    </message>
    <message>
        <source>Remove light</source>
        <translation>Lichtquelle entfernen</translation>
    </message>
    <message>
        <source>At most %1 lights are possible</source>
        <translation>Höchstens %1 Lichtquellen sind möglich</translation>
    </message>
    <message>
        <source>Remove isosurface</source>
        <translation>Isofläche entfernen</translation>
    </message>
    <message>
        <source>At most %1 isosurfaces are possible</source>
        <translation>Höchstens %1 Isoflächen sind möglich</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>Other labels</source>
        <translation>Übrige Labels</translation>
    </message>
    <message>
        <source>Labels %1</source>
        <translation>Labels %1</translation>
    </message>
</context>
<context>
    <name>files</name>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>DICOM</source>
        <translation>DICOM</translation>
    </message>
    <message>
        <source>HDF5</source>
        <translation>HDF5</translation>
    </message>
    <message>
        <source>FreeSurfer</source>
        <translation>FreeSurfer</translation>
    </message>
    <message>
        <source>MetaImage</source>
        <translation>MetaImage</translation>
    </message>
    <message>
        <source>NIfTI</source>
        <translation>NIfTI</translation>
    </message>
    <message>
        <source>NRRD</source>
        <translation>NRRD</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Roh</translation>
    </message>
    <message>
        <source>TIFF</source>
        <translation>TIFF</translation>
    </message>
    <message>
        <source>Triangle meshes</source>
        <translation>Dreiecksnetze</translation>
    </message>
    <message>
        <source>VTK</source>
        <translation>VTK</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Zarr</source>
        <translation>Zarr</translation>
    </message>
</context>
<context>
    <name>help</name>
    <message>
        <source>3-D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>&lt;b&gt;Left drag&lt;/b&gt;</source>
        <translation>&lt;b&gt;Ziehen links&lt;/b&gt;</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Middle drag&lt;/b&gt;, &lt;b&gt;Shift+left drag&lt;/b&gt;</source>
        <translation>&lt;b&gt;Ziehen Mitte&lt;/b&gt;, &lt;b&gt;Umschalt+Ziehen links&lt;/b&gt;</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>&lt;b&gt;Right drag&lt;/b&gt;, &lt;b&gt;wheel&lt;/b&gt;</source>
        <translation>&lt;b&gt;Ziehen rechts&lt;/b&gt;, &lt;b&gt;Mausrad&lt;/b&gt;</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+left drag&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+Ziehen links&lt;/b&gt;</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>rollen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Arrows&lt;/b&gt;, &lt;b&gt;Shift+arrows&lt;/b&gt;</source>
        <translation>&lt;b&gt;Pfeile&lt;/b&gt;, &lt;b&gt;Umschalt+Pfeile&lt;/b&gt;</translation>
    </message>
    <message>
        <source>rotate by 5°, pan</source>
        <translation>um 5° drehen, verschieben</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+left, right&lt;/b&gt;, &lt;b&gt;+ −&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+links, rechts&lt;/b&gt;, &lt;b&gt;+ −&lt;/b&gt;</translation>
    </message>
    <message>
        <source>roll by 5°, zoom</source>
        <translation>um 5° rollen, zoomen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Double click&lt;/b&gt;</source>
        <translation>&lt;b&gt;Doppelklick&lt;/b&gt;</translation>
    </message>
    <message>
        <source>centre the surface point</source>
        <translation>Oberflächenpunkt zentrieren</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click on the cube&lt;/b&gt;</source>
        <translation>&lt;b&gt;Klick auf den Würfel&lt;/b&gt;</translation>
    </message>
    <message>
        <source>view from that side</source>
        <translation>Ansicht von dieser Seite</translation>
    </message>
    <message>
        <source>&lt;b&gt;1 2 3 4 5 6&lt;/b&gt;</source>
        <translation>&lt;b&gt;1 2 3 4 5 6&lt;/b&gt;</translation>
    </message>
    <message>
        <source>view from anterior, posterior, left, right, superior, inferior (unknown orientation: front, back, +X, −X, above, below)</source>
        <translation>Ansicht von anterior, posterior, links, rechts, superior, inferior (Orientierung unbekannt: vorn, hinten, +X, −X, oben, unten)</translation>
    </message>
    <message>
        <source>&lt;b&gt;R&lt;/b&gt;, &lt;b&gt;F&lt;/b&gt;, &lt;b&gt;O&lt;/b&gt;</source>
        <translation>&lt;b&gt;R&lt;/b&gt;, &lt;b&gt;F&lt;/b&gt;, &lt;b&gt;O&lt;/b&gt;</translation>
    </message>
    <message>
        <source>reset view, zoom to fit, orthographic</source>
        <translation>Ansicht zurücksetzen, einpassen, orthographisch</translation>
    </message>
    <message>
        <source>&lt;b&gt;L&lt;/b&gt;, &lt;b&gt;Shift+L&lt;/b&gt;</source>
        <translation>&lt;b&gt;L&lt;/b&gt;, &lt;b&gt;Umschalt+L&lt;/b&gt;</translation>
    </message>
    <message>
        <source>next, previous look</source>
        <translation>nächste, vorige Darstellung</translation>
    </message>
    <message>
        <source>&lt;b&gt;Space&lt;/b&gt;</source>
        <translation>&lt;b&gt;Leertaste&lt;/b&gt;</translation>
    </message>
    <message>
        <source>animate the flow, stop it</source>
        <translation>Strömung bewegen, anhalten</translation>
    </message>
    <message>
        <source>&lt;b&gt;Right click&lt;/b&gt;, &lt;b&gt;Menu key&lt;/b&gt;</source>
        <translation>&lt;b&gt;Rechtsklick&lt;/b&gt;, &lt;b&gt;Menütaste&lt;/b&gt;</translation>
    </message>
    <message>
        <source>hide or keep the piece under the pointer</source>
        <translation>Teil unter dem Zeiger ausblenden oder behalten</translation>
    </message>
    <message>
        <source>&lt;b&gt;P&lt;/b&gt;, &lt;b&gt;M&lt;/b&gt;, &lt;b&gt;Shift+M&lt;/b&gt;</source>
        <translation>&lt;b&gt;P&lt;/b&gt;, &lt;b&gt;M&lt;/b&gt;, &lt;b&gt;Umschalt+M&lt;/b&gt;</translation>
    </message>
    <message>
        <source>pin, distance, geodesic distance</source>
        <translation>Pin, Abstand, geodätischer Abstand</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt;, &lt;b&gt;Shift+click&lt;/b&gt;</source>
        <translation>&lt;b&gt;Klick&lt;/b&gt;, &lt;b&gt;Umschalt+Klick&lt;/b&gt;</translation>
    </message>
    <message>
        <source>set a point, add more points (measuring)</source>
        <translation>Punkt setzen, weitere Punkte hinzufügen (beim Messen)</translation>
    </message>
    <message>
        <source>&lt;b&gt;Backspace&lt;/b&gt;, &lt;b&gt;Esc&lt;/b&gt;</source>
        <translation>&lt;b&gt;Rücktaste&lt;/b&gt;, &lt;b&gt;Esc&lt;/b&gt;</translation>
    </message>
    <message>
        <source>remove the last point, end measuring</source>
        <translation>letzten Punkt entfernen, Messen beenden</translation>
    </message>
    <message>
        <source>&lt;b&gt;C&lt;/b&gt;, &lt;b&gt;Shift+C&lt;/b&gt;, &lt;b&gt;Shift+X&lt;/b&gt;</source>
        <translation>&lt;b&gt;C&lt;/b&gt;, &lt;b&gt;Umschalt+C&lt;/b&gt;, &lt;b&gt;Umschalt+X&lt;/b&gt;</translation>
    </message>
    <message>
        <source>clip plane facing the viewer, reverse the last plane, remove all</source>
        <translation>Schnittebene senkrecht zur Blickrichtung, letzte Ebene umkehren, alle entfernen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Handles of cuts&lt;/b&gt;</source>
        <translation>&lt;b&gt;Griffe der Schnitte&lt;/b&gt;</translation>
    </message>
    <message>
        <source>drag: move, turn (Ctrl: snap; Esc: cancel); wheel: step by a voxel; right click: menu</source>
        <translation>Ziehen: bewegen, drehen (Strg: einrasten; Esc: abbrechen); Mausrad: um ein Voxel weiter; Rechtsklick: Menü</translation>
    </message>
    <message>
        <source>&lt;b&gt;Handles of lights&lt;/b&gt;</source>
        <translation>&lt;b&gt;Griffe der Lichtquellen&lt;/b&gt;</translation>
    </message>
    <message>
        <source>drag: move (Ctrl, wheel: distance); outline: radius</source>
        <translation>Ziehen: bewegen (Strg, Mausrad: Entfernung); Umriss: Radius</translation>
    </message>
    <message>
        <source>&lt;b&gt;Shift+right drag&lt;/b&gt;</source>
        <translation>&lt;b&gt;Umschalt+Ziehen rechts&lt;/b&gt;</translation>
    </message>
    <message>
        <source>turn the environment</source>
        <translation>Umgebung drehen</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt;, &lt;b&gt;drag&lt;/b&gt;, &lt;b&gt;arrows&lt;/b&gt;</source>
        <translation>&lt;b&gt;Klick&lt;/b&gt;, &lt;b&gt;Ziehen&lt;/b&gt;, &lt;b&gt;Pfeile&lt;/b&gt;</translation>
    </message>
    <message>
        <source>move the crosshair (or click the surface)</source>
        <translation>Fadenkreuz bewegen (oder auf die Fläche klicken)</translation>
    </message>
    <message>
        <source>&lt;b&gt;Wheel&lt;/b&gt;, &lt;b&gt;Page Up&lt;/b&gt;, &lt;b&gt;Page Down&lt;/b&gt;</source>
        <translation>&lt;b&gt;Mausrad&lt;/b&gt;, &lt;b&gt;Bild auf&lt;/b&gt;, &lt;b&gt;Bild ab&lt;/b&gt;</translation>
    </message>
    <message>
        <source>step by a voxel (moves the cut that the slice shows)</source>
        <translation>um ein Voxel weiter (bewegt den Schnitt, den die Schicht zeigt)</translation>
    </message>
    <message>
        <source>&lt;b&gt;Right drag&lt;/b&gt;</source>
        <translation>&lt;b&gt;Ziehen rechts&lt;/b&gt;</translation>
    </message>
    <message>
        <source>level (vertical) and width (horizontal)</source>
        <translation>Fenstermitte (senkrecht) und -breite (waagerecht)</translation>
    </message>
    <message>
        <source>plane, slab, CT windows, contours</source>
        <translation>Ebene, dicke Schicht, CT-Fenster, Konturen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Middle drag&lt;/b&gt;, &lt;b&gt;Shift+left drag&lt;/b&gt;, &lt;b&gt;Shift+arrows&lt;/b&gt;</source>
        <translation>&lt;b&gt;Ziehen Mitte&lt;/b&gt;, &lt;b&gt;Umschalt+Ziehen links&lt;/b&gt;, &lt;b&gt;Umschalt+Pfeile&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+wheel&lt;/b&gt;, &lt;b&gt;+ −&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+Mausrad&lt;/b&gt;, &lt;b&gt;+ −&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Double click&lt;/b&gt;, &lt;b&gt;Home&lt;/b&gt;</source>
        <translation>&lt;b&gt;Doppelklick&lt;/b&gt;, &lt;b&gt;Pos1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>whole slice</source>
        <translation>ganze Schicht</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag&lt;/b&gt;, &lt;b&gt;click&lt;/b&gt;</source>
        <translation>&lt;b&gt;Ziehen&lt;/b&gt;, &lt;b&gt;Klick&lt;/b&gt;</translation>
    </message>
    <message>
        <source>set the isovalue</source>
        <translation>Isowert setzen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Wheel&lt;/b&gt;, &lt;b&gt;arrows&lt;/b&gt;, &lt;b&gt;Page Up&lt;/b&gt;, &lt;b&gt;Page Down&lt;/b&gt;</source>
        <translation>&lt;b&gt;Mausrad&lt;/b&gt;, &lt;b&gt;Pfeile&lt;/b&gt;, &lt;b&gt;Bild auf&lt;/b&gt;, &lt;b&gt;Bild ab&lt;/b&gt;</translation>
    </message>
    <message>
        <source>fine steps (Shift: tenfold)</source>
        <translation>feine Schritte (Umschalt: zehnfach)</translation>
    </message>
    <message>
        <source>&lt;b&gt;Alt+click&lt;/b&gt;, &lt;b&gt;right click&lt;/b&gt;</source>
        <translation>&lt;b&gt;Alt+Klick&lt;/b&gt;, &lt;b&gt;Rechtsklick&lt;/b&gt;</translation>
    </message>
    <message>
        <source>add an isosurface, menu</source>
        <translation>Isofläche hinzufügen, Menü</translation>
    </message>
    <message>
        <source>suggested isovalue</source>
        <translation>vorgeschlagener Isowert</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+wheel&lt;/b&gt;, &lt;b&gt;middle drag&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+Mausrad&lt;/b&gt;, &lt;b&gt;Ziehen Mitte&lt;/b&gt;</translation>
    </message>
    <message>
        <source>zoom, pan the value axis</source>
        <translation>Wertachse zoomen, verschieben</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+N&lt;/b&gt;, &lt;b&gt;Ctrl+O&lt;/b&gt;, &lt;b&gt;Ctrl+Shift+O&lt;/b&gt;, &lt;b&gt;Ctrl+Shift+D&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+N&lt;/b&gt;, &lt;b&gt;Strg+O&lt;/b&gt;, &lt;b&gt;Strg+Umschalt+O&lt;/b&gt;, &lt;b&gt;Strg+Umschalt+D&lt;/b&gt;</translation>
    </message>
    <message>
        <source>new window, open a file, a folder, DICOM browser</source>
        <translation>neues Fenster, Datei öffnen, Ordner öffnen, DICOM-Browser</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+S&lt;/b&gt;, &lt;b&gt;Ctrl+Shift+S&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+S&lt;/b&gt;, &lt;b&gt;Strg+Umschalt+S&lt;/b&gt;</translation>
    </message>
    <message>
        <source>save session, save as</source>
        <translation>Sitzung speichern, speichern unter</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+E&lt;/b&gt;, &lt;b&gt;Ctrl+C&lt;/b&gt;, &lt;b&gt;Ctrl+Shift+C&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+E&lt;/b&gt;, &lt;b&gt;Strg+C&lt;/b&gt;, &lt;b&gt;Strg+Umschalt+C&lt;/b&gt;</translation>
    </message>
    <message>
        <source>save the image, copy it, copy its command line</source>
        <translation>Bild speichern, kopieren, Befehlszeile kopieren</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+R&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+R&lt;/b&gt;</translation>
    </message>
    <message>
        <source>start, stop recording</source>
        <translation>Aufzeichnung beginnen, beenden</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+Z&lt;/b&gt;, &lt;b&gt;Ctrl+Shift+Z&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+Z&lt;/b&gt;, &lt;b&gt;Strg+Umschalt+Z&lt;/b&gt;</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>rückgängig, wiederholen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+F&lt;/b&gt;, &lt;b&gt;Ctrl+,&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+F&lt;/b&gt;, &lt;b&gt;Strg+,&lt;/b&gt;</translation>
    </message>
    <message>
        <source>find a setting, preferences</source>
        <translation>Einstellung suchen, Programmeinstellungen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Delete&lt;/b&gt;</source>
        <translation>&lt;b&gt;Entf&lt;/b&gt;</translation>
    </message>
    <message>
        <source>delete selected measurements (panel &lt;i&gt;Measure&lt;/i&gt;)</source>
        <translation>gewählte Messungen löschen (Bedienfeld &lt;i&gt;Messen&lt;/i&gt;)</translation>
    </message>
    <message>
        <source>&lt;b&gt;F4&lt;/b&gt;</source>
        <translation>&lt;b&gt;F4&lt;/b&gt;</translation>
    </message>
    <message>
        <source>next layout: 3-D view, with slices, slices alone</source>
        <translation>nächste Anordnung: 3D-Ansicht, mit Schichten, nur Schichten</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+0&lt;/b&gt;, &lt;b&gt;Ctrl+1 … 7&lt;/b&gt;</source>
        <translation>&lt;b&gt;Strg+0&lt;/b&gt;, &lt;b&gt;Strg+1 … 7&lt;/b&gt;</translation>
    </message>
    <message>
        <source>go to the 3-D view, to a panel</source>
        <translation>zur 3D-Ansicht, zu einem Bedienfeld</translation>
    </message>
    <message>
        <source>&lt;b&gt;F6&lt;/b&gt;, &lt;b&gt;Shift+F6&lt;/b&gt;</source>
        <translation>&lt;b&gt;F6&lt;/b&gt;, &lt;b&gt;Umschalt+F6&lt;/b&gt;</translation>
    </message>
    <message>
        <source>next, previous part of the window</source>
        <translation>nächster, voriger Teil des Fensters</translation>
    </message>
    <message>
        <source>&lt;b&gt;F1&lt;/b&gt;, &lt;b&gt;F11&lt;/b&gt;, &lt;b&gt;Ctrl+Q&lt;/b&gt;</source>
        <translation>&lt;b&gt;F1&lt;/b&gt;, &lt;b&gt;F11&lt;/b&gt;, &lt;b&gt;Strg+Q&lt;/b&gt;</translation>
    </message>
    <message>
        <source>help, full screen (Esc: back), quit</source>
        <translation>Hilfe, Vollbild (Esc: zurück), beenden</translation>
    </message>
    <message>
        <source>&lt;b&gt;T&lt;/b&gt;</source>
        <translation>&lt;b&gt;T&lt;/b&gt;</translation>
    </message>
    <message>
        <source>play the time steps, pause</source>
        <translation>Zeitschritte abspielen, anhalten</translation>
    </message>
</context>
<context>
    <name>isolux::ui::AccuracyChart</name>
    <message>
        <source>Error against time</source>
        <translation>Fehler über der Zeit</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Current setting</source>
        <translation>Aktuelle Einstellung</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
</context>
<context>
    <name>isolux::ui::AccuracyPanel</name>
    <message>
        <source>light computation time, s</source>
        <translation>Zeit der Lichtberechnung, s</translation>
    </message>
    <message>
        <source>light lookup time, ms</source>
        <translation>Lesezeit des Lichts, ms</translation>
    </message>
    <message>
        <source>graphics memory, MiB</source>
        <translation>Grafikspeicher, MiB</translation>
    </message>
    <message>
        <source>render time of these passes, ms</source>
        <translation>Renderzeit dieser Durchgänge, ms</translation>
    </message>
    <message>
        <source>depth error, voxels</source>
        <translation>Tiefenfehler, Voxel</translation>
    </message>
    <message>
        <source>normal error, degrees</source>
        <translation>Normalenfehler, Grad</translation>
    </message>
    <message>
        <source>relative curvature error</source>
        <translation>relativer Krümmungsfehler</translation>
    </message>
    <message>
        <source>relative light error</source>
        <translation>relativer Lichtfehler</translation>
    </message>
    <message>
        <source>Square: current setting. Ring: default. Dashed line: no other value is as accurate in less time. Click a point to use its value.</source>
        <translation>Quadrat: aktuelle Einstellung. Ring: Standard. Gestrichelt: kein anderer Wert ist in weniger Zeit so genau. Ein Klick auf einen Punkt übernimmt dessen Wert.</translation>
    </message>
    <message>
        <source>Quality setting (accuracy against time)</source>
        <translation>Qualitätseinstellung (Genauigkeit gegen Zeit)</translation>
    </message>
    <message>
        <source>Open a volume to plot its accuracy against render time.</source>
        <translation>Ein Volumen öffnen, um seine Genauigkeit gegen die Renderzeit aufzutragen.</translation>
    </message>
    <message>
        <source>Measuring… %1 %</source>
        <translation>Messung … %1 %</translation>
    </message>
    <message>
        <source>Waiting until the window is idle</source>
        <translation>Warten, bis das Fenster ruht</translation>
    </message>
    <message>
        <source>This chart belongs to an earlier view or scene</source>
        <translation>Das Diagramm gehört zu einer früheren Ansicht oder Szene</translation>
    </message>
    <message>
        <source>Measured on the CPU at %1 × %2 pixels of this view, against double precision</source>
        <translation>Auf der CPU mit %1 × %2 Pixeln dieser Ansicht gemessen, gegenüber doppelter Genauigkeit</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>render time, ms</source>
        <translation>Renderzeit, ms</translation>
    </message>
    <message>
        <source>error at edges, fraction of the range</source>
        <translation>Fehler an Rändern, Anteil des Bereichs</translation>
    </message>
    <message>
        <source>Measuring the image on screen…</source>
        <translation>Das Bild auf dem Bildschirm wird gemessen …</translation>
    </message>
</context>
<context>
    <name>isolux::ui::ColorButton</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
</context>
<context>
    <name>isolux::ui::ColorPointsView</name>
    <message>
        <source>Colour bar with control points</source>
        <translation>Farbbalken mit Kontrollpunkten</translation>
    </message>
    <message>
        <source>Point %1 of %2 at %3</source>
        <translation>Punkt %1 von %2 bei %3</translation>
    </message>
    <message>
        <source>Position of the selected point</source>
        <translation>Position des gewählten Punktes</translation>
    </message>
    <message>
        <source>Position of the selected point, as a fraction of the range</source>
        <translation>Position des gewählten Punktes als Bruchteil des Bereichs</translation>
    </message>
    <message>
        <source>Add a point (click on the bar, or Insert)</source>
        <translation>Punkt hinzufügen (auf den Balken klicken, oder Einfg)</translation>
    </message>
</context>
<context>
    <name>isolux::ui::CurvatureMapView</name>
    <message>
        <source>Colour map of the principal curvatures</source>
        <translation>Farbskala der Hauptkrümmungen</translation>
    </message>
    <message>
        <source>cap</source>
        <translation>Kuppe</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>Grat</translation>
    </message>
    <message>
        <source>saddle</source>
        <translation>Sattel</translation>
    </message>
    <message>
        <source>cup</source>
        <translation>Mulde</translation>
    </message>
    <message>
        <source>valley</source>
        <translation>Tal</translation>
    </message>
    <message>
        <source>%1 of the selected point, as a fraction of the range</source>
        <translation>%1 des gewählten Punktes, als Anteil des Bereichs</translation>
    </message>
    <message>
        <source>Add a point (double click on the map)</source>
        <translation>Punkt hinzufügen (Doppelklick auf die Skala)</translation>
    </message>
</context>
<context>
    <name>isolux::ui::CutMenu</name>
    <message>
        <source>Show &amp;handles</source>
        <translation>&amp;Griffe zeigen</translation>
    </message>
    <message>
        <source>Show handles of planes and box in the 3-D view</source>
        <translation>Griffe von Ebenen und Quader in der 3D-Ansicht zeigen</translation>
    </message>
    <message>
        <source>&amp;Remove all cuts</source>
        <translation>Alle Schnitte &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove all planes and boxes</source>
        <translation>Alle Ebenen und Quader entfernen</translation>
    </message>
    <message>
        <source>Add a plane through the crosshair or the view’s target, and cut away the part in front of it</source>
        <translation>Eine Ebene durch das Fadenkreuz oder das Ziel der Ansicht hinzufügen und den Teil davor wegschneiden</translation>
    </message>
    <message>
        <source>Plane facing the &amp;viewer</source>
        <translation>Ebene senkrecht zur &amp;Blickrichtung</translation>
    </message>
    <message>
        <source>Plane &amp;through three points</source>
        <translation>Ebene durch &amp;drei Punkte</translation>
    </message>
    <message>
        <source>Add a plane through the points of the selected measurement, or the last three points set</source>
        <translation>Eine Ebene durch die Punkte der gewählten Messung oder die drei zuletzt gesetzten Punkte hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Box</source>
        <translation>&amp;Quader</translation>
    </message>
    <message>
        <source>Add a box and cut away everything outside it</source>
        <translation>Einen Quader hinzufügen und alles außerhalb wegschneiden</translation>
    </message>
    <message>
        <source>Revers&amp;e last plane</source>
        <translation>Letzte Ebene &amp;umkehren</translation>
    </message>
    <message>
        <source>Cut away the other side of the plane</source>
        <translation>Die andere Seite der Ebene wegschneiden</translation>
    </message>
    <message>
        <source>Reverse plane %1</source>
        <translation>Ebene %1 umkehren</translation>
    </message>
    <message>
        <source>Plane &amp;%1</source>
        <translation>Ebene &amp;%1</translation>
    </message>
    <message>
        <source>Revers&amp;e</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Align to the nearest &amp;axis</source>
        <translation>An der nächsten &amp;Achse ausrichten</translation>
    </message>
    <message>
        <source>Align its normal with an axis</source>
        <translation>Ihre Normale an einer Achse ausrichten</translation>
    </message>
    <message>
        <source>Align plane %1</source>
        <translation>Ebene %1 ausrichten</translation>
    </message>
    <message>
        <source>Turn to the &amp;viewer</source>
        <translation>Zum &amp;Betrachter drehen</translation>
    </message>
    <message>
        <source>Turn its normal towards the viewer</source>
        <translation>Ihre Normale zum Betrachter drehen</translation>
    </message>
    <message>
        <source>Turn plane %1 to the viewer</source>
        <translation>Ebene %1 zum Betrachter drehen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove this plane</source>
        <translation>Diese Ebene entfernen</translation>
    </message>
    <message>
        <source>Bo&amp;x</source>
        <translation>Quade&amp;r</translation>
    </message>
    <message>
        <source>&amp;Align to the axes</source>
        <translation>An den &amp;Achsen ausrichten</translation>
    </message>
    <message>
        <source>Turn the box back to the axes</source>
        <translation>Den Quader auf die Achsen zurückdrehen</translation>
    </message>
    <message>
        <source>Align the box</source>
        <translation>Quader ausrichten</translation>
    </message>
    <message>
        <source>Remove this box</source>
        <translation>Diesen Quader entfernen</translation>
    </message>
    <message>
        <source>Cut &amp;faces</source>
        <translation>Schnitt&amp;flächen</translation>
    </message>
    <message>
        <source>Change cut faces</source>
        <translation>Schnittflächen ändern</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keine</translation>
    </message>
    <message>
        <source>Leave the cut open and show the back faces of surfaces</source>
        <translation>Den Schnitt offen lassen und die Rückseiten der Flächen zeigen</translation>
    </message>
    <message>
        <source>Values &amp;inside</source>
        <translation>Werte &amp;innen</translation>
    </message>
    <message>
        <source>Show voxel values where the inside of a surface is cut</source>
        <translation>Voxelwerte zeigen, wo das Innere einer Fläche geschnitten ist</translation>
    </message>
    <message>
        <source>&amp;Whole slice</source>
        <translation>&amp;Ganze Schicht</translation>
    </message>
    <message>
        <source>Show voxel values on the whole cap</source>
        <translation>Voxelwerte auf der ganzen Schnittfläche zeigen</translation>
    </message>
    <message>
        <source>Cut s&amp;urfaces</source>
        <translation>Geschnittene F&amp;lächen</translation>
    </message>
    <message>
        <source>Isosurface &amp;%1</source>
        <translation>Isofläche &amp;%1</translation>
    </message>
    <message>
        <source>Let planes and box cut this surface</source>
        <translation>Ebenen und Quader diese Fläche schneiden lassen</translation>
    </message>
    <message>
        <source>&amp;Axial plane</source>
        <translation>&amp;Axiale Ebene</translation>
    </message>
    <message>
        <source>Plane across &amp;Z</source>
        <translation>Ebene quer zu &amp;Z</translation>
    </message>
    <message>
        <source>&amp;Coronal plane</source>
        <translation>&amp;Koronale Ebene</translation>
    </message>
    <message>
        <source>Plane across &amp;Y</source>
        <translation>Ebene quer zu &amp;Y</translation>
    </message>
    <message>
        <source>&amp;Sagittal plane</source>
        <translation>&amp;Sagittale Ebene</translation>
    </message>
    <message>
        <source>Plane across &amp;X</source>
        <translation>Ebene quer zu &amp;X</translation>
    </message>
    <message>
        <source>Open a volume first.</source>
        <translation>Erst ein Volumen öffnen.</translation>
    </message>
    <message>
        <source>At most %1 planes are possible: remove one first.</source>
        <translation>Höchstens %1 Ebenen sind möglich: erst eine entfernen.</translation>
    </message>
    <message>
        <source>Nothing is cut: add a plane or a box first.</source>
        <translation>Nichts ist geschnitten: erst eine Ebene oder einen Quader hinzufügen.</translation>
    </message>
    <message>
        <source>Set three points first, with a tool of the Measure menu.</source>
        <translation>Erst drei Punkte setzen, mit einem Werkzeug des Menüs Messen.</translation>
    </message>
    <message>
        <source>The scene already has a box: drag its faces.</source>
        <translation>Die Szene hat schon einen Quader: an seinen Seiten ziehen.</translation>
    </message>
    <message>
        <source>The scene has no plane.</source>
        <translation>Die Szene hat keine Ebene.</translation>
    </message>
    <message>
        <source>The box is not turned.</source>
        <translation>Der Quader ist nicht gedreht.</translation>
    </message>
    <message>
        <source>Plane facing the viewer</source>
        <translation>Ebene senkrecht zur Blickrichtung</translation>
    </message>
    <message>
        <source>Plane through three points</source>
        <translation>Ebene durch drei Punkte</translation>
    </message>
    <message>
        <source>The three points are collinear: set another point off their line.</source>
        <translation>Die drei Punkte liegen auf einer Geraden: einen weiteren Punkt abseits davon setzen.</translation>
    </message>
    <message>
        <source>Remove plane %1</source>
        <translation>Ebene %1 entfernen</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Remove the box</source>
        <translation>Quader entfernen</translation>
    </message>
    <message>
        <source>Remove all cuts</source>
        <translation>Alle Schnitte entfernen</translation>
    </message>
    <message>
        <source>Cut isosurface %1</source>
        <translation>Isofläche %1 schneiden</translation>
    </message>
    <message>
        <source>Do not cut isosurface %1</source>
        <translation>Isofläche %1 nicht schneiden</translation>
    </message>
    <message>
        <source>Cut a c&amp;orner away</source>
        <translation>&amp;Ecke abschneiden</translation>
    </message>
    <message>
        <source>Remove the eighth towards the viewer, from the crosshair or the centre of the view</source>
        <translation>Das Achtel zum Betrachter hin entfernen, ab dem Fadenkreuz oder der Mitte der Ansicht</translation>
    </message>
    <message>
        <source>Corner %1</source>
        <translation>Ecke %1</translation>
    </message>
    <message>
        <source>Restore this corner</source>
        <translation>Diese Ecke wiederherstellen</translation>
    </message>
    <message>
        <source>Remove corner %1</source>
        <translation>Ecke %1 entfernen</translation>
    </message>
    <message>
        <source>At most %1 corners: remove one first.</source>
        <translation>Höchstens %1 Ecken: zuerst eine entfernen.</translation>
    </message>
    <message>
        <source>Cut a corner away</source>
        <translation>Ecke abschneiden</translation>
    </message>
</context>
<context>
    <name>isolux::ui::DicomBrowser</name>
    <message>
        <source>&amp;Hide patient data</source>
        <translation>&amp;Patientendaten verbergen</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>DICOM browser</source>
        <translation>DICOM-Browser</translation>
    </message>
    <message>
        <source>Search patients, descriptions, dates, modalities</source>
        <translation>Patienten, Beschreibungen, Daten, Modalitäten suchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Ordner …</translation>
    </message>
    <message>
        <source>Search another folder or disc</source>
        <translation>Einen anderen Ordner oder Datenträger durchsuchen</translation>
    </message>
    <message>
        <source>Show names, IDs and birth dates as “anonymous”, here and in the window</source>
        <translation>Namen, Kennungen und Geburtsdaten hier und im Fenster als „anonym“ zeigen</translation>
    </message>
    <message>
        <source>Patients, studies and series</source>
        <translation>Patienten, Studien und Serien</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Voxelabstand</translation>
    </message>
    <message>
        <source>Kernel</source>
        <translation>Kernel</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Search a folder or disc</source>
        <translation>Einen Ordner oder Datenträger durchsuchen</translation>
    </message>
    <message>
        <source>anonymous %1</source>
        <translation>anonym %1</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>Ohne Namen</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>Kennung %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geboren %1</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Cannot be opened: %1</source>
        <translation>Kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>Evenly spaced slices; no warnings.</source>
        <translation>Gleichmäßig verteilte Schichten; keine Warnungen.</translation>
    </message>
    <message>
        <source>(folder hidden)</source>
        <translation>(Ordner verborgen)</translation>
    </message>
    <message>
        <source>%1 series of %2 patients</source>
        <translation>Serien: %1, Patienten: %2</translation>
    </message>
    <message>
        <source>Choose a folder or disc with DICOM files.</source>
        <translation>Einen Ordner oder Datenträger mit DICOM-Dateien wählen.</translation>
    </message>
    <message>
        <source>No DICOM images in this folder.</source>
        <translation>Keine DICOM-Bilder in diesem Ordner.</translation>
    </message>
    <message>
        <source>search in progress</source>
        <translation>Suche läuft</translation>
    </message>
    <message>
        <source>some could not be read</source>
        <translation>einige waren nicht lesbar</translation>
    </message>
    <message>
        <source>%1 of %2 files could not be read</source>
        <translation>%1 von %2 Dateien waren nicht lesbar</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
</context>
<context>
    <name>isolux::ui::Document</name>
    <message>
        <source>is a recording; render it with isolux replay %1 --out FOLDER</source>
        <translation>ist eine Aufzeichnung; Bilder daraus macht isolux replay %1 --out ORDNER</translation>
    </message>
    <message>
        <source>Keep the volume</source>
        <translation>Volumen behalten</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>Pause flow</source>
        <translation>Strömung anhalten</translation>
    </message>
    <message>
        <source>Animate flow</source>
        <translation>Strömung bewegen</translation>
    </message>
    <message>
        <source>Recording stopped: %1. The file contains everything up to that point.</source>
        <translation>Die Aufzeichnung endete: %1. Die Datei enthält alles bis dahin.</translation>
    </message>
    <message>
        <source>Coarser level</source>
        <translation>Gröbere Stufe</translation>
    </message>
    <message>
        <source>Skip unreadable chunks</source>
        <translation>Unlesbare Blöcke überspringen</translation>
    </message>
    <message>
        <source>Reset all settings</source>
        <translation>Alle Einstellungen zurücksetzen</translation>
    </message>
    <message>
        <source>Play time steps</source>
        <translation>Zeitschritte abspielen</translation>
    </message>
</context>
<context>
    <name>isolux::ui::DocumentKeeper</name>
    <message>
        <source>Recording %1 was interrupted and is not continued</source>
        <translation>Die Aufzeichnung %1 wurde unterbrochen und wird nicht fortgesetzt</translation>
    </message>
    <message>
        <source>Autosave failed: %1. Save the session; Isolux tries again every minute.</source>
        <translation>Automatisches Sichern fehlgeschlagen: %1. Bitte die Sitzung speichern; Isolux versucht es jede Minute erneut.</translation>
    </message>
</context>
<context>
    <name>isolux::ui::EnvironmentPreview</name>
    <message>
        <source>Environment map</source>
        <translation>Umgebungsbild</translation>
    </message>
    <message>
        <source>Drag to turn the environment about the vertical axis. The cross marks the view direction.</source>
        <translation>Ziehen dreht die Umgebung um die senkrechte Achse. Das Kreuz zeigt die Blickrichtung.</translation>
    </message>
    <message>
        <source>Loading the environment…</source>
        <translation>Umgebung wird geladen …</translation>
    </message>
</context>
<context>
    <name>isolux::ui::ErrorOverlayBox</name>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Errors shown in the image</source>
        <translation>Im Bild gezeigte Fehler</translation>
    </message>
    <message>
        <source>Overlays the bounds of this error on the final image as colours. Hatched pixels may exceed the limit entered above, or are uncertain</source>
        <translation>Legt die Schranken dieses Fehlers als Farben über das fertige Bild. Schraffierte Pixel können die oben eingegebene Grenze überschreiten oder sind unsicher</translation>
    </message>
    <message>
        <source>Error overlay</source>
        <translation>Fehleranzeige im Bild</translation>
    </message>
    <message>
        <source>This image has no baked light, or a surface is transparent; the look Global illumination bakes light</source>
        <translation>Dieses Bild hat kein gespeichertes Licht, oder eine Fläche ist durchsichtig; die Darstellung Globale Beleuchtung speichert Licht</translation>
    </message>
    <message>
        <source>Depth (noise, discretisation)</source>
        <translation>Tiefe (Rauschen, Diskretisierung)</translation>
    </message>
    <message>
        <source>Normals (noise)</source>
        <translation>Normalen (Rauschen)</translation>
    </message>
    <message>
        <source>Curvature (noise)</source>
        <translation>Krümmung (Rauschen)</translation>
    </message>
    <message>
        <source>Depth (rounding)</source>
        <translation>Tiefe (Rundung)</translation>
    </message>
    <message>
        <source>Normals (rounding)</source>
        <translation>Normalen (Rundung)</translation>
    </message>
    <message>
        <source>Curvature (rounding)</source>
        <translation>Krümmung (Rundung)</translation>
    </message>
</context>
<context>
    <name>isolux::ui::FullResolutionView</name>
    <message>
        <source>Full resolution is not drawn: %1</source>
        <translation>Volle Auflösung wird nicht gezeichnet: %1</translation>
    </message>
    <message>
        <source>drawing full resolution</source>
        <translation>volle Auflösung wird gezeichnet</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>Full resolution is drawn from the file once its index exists.</source>
        <translation>Die volle Auflösung wird aus der Datei gezeichnet, sobald deren Index vorliegt.</translation>
    </message>
    <message>
        <source>When the view is idle, the image shows the file at full resolution (level 0).</source>
        <translation>Ruht die Ansicht, zeigt das Bild die Datei in voller Auflösung (Stufe 0).</translation>
    </message>
    <message>
        <source>%1 % of the image is hatched, because the volume is unreadable there: %2</source>
        <translation>%1 % des Bildes sind schraffiert, weil das Volumen dort nicht lesbar ist: %2</translation>
    </message>
    <message>
        <source>%1 % of the image is missing; raise Graphics memory (memory.gpu_budget_mb)</source>
        <translation>%1 % des Bildes fehlen; Grafikspeicher (memory.gpu_budget_mb) erhöhen</translation>
    </message>
    <message>
        <source>waiting for the image was cancelled</source>
        <translation>das Warten auf das Bild wurde abgebrochen</translation>
    </message>
</context>
<context>
    <name>isolux::ui::HistogramSlider</name>
    <message>
        <source>Isovalue on the histogram</source>
        <translation>Isowert im Histogramm</translation>
    </message>
    <message>
        <source>The histogram of the volume appears here</source>
        <translation>Hier erscheint das Histogramm des Volumens</translation>
    </message>
    <message>
        <source>Add isosurface at %1</source>
        <translation>Isofläche bei %1 hinzufügen</translation>
    </message>
    <message>
        <source>Suggested isovalue</source>
        <translation>Vorgeschlagener Isowert</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Ganzer Bereich</translation>
    </message>
</context>
<context>
    <name>isolux::ui::IsovaluePanel</name>
    <message>
        <source>Isovalue</source>
        <translation>Isowert</translation>
    </message>
    <message>
        <source>Exact isovalue. Arrow keys change it by one histogram step.</source>
        <translation>Genauer Isowert. Pfeiltasten ändern ihn um einen Schritt des Histogramms.</translation>
    </message>
    <message>
        <source>Suggested</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>Use the isovalue suggested by the histogram (also: double click on the histogram)</source>
        <translation>Den vom Histogramm vorgeschlagenen Isowert verwenden (auch: Doppelklick auf das Histogramm)</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Ganzer Bereich</translation>
    </message>
    <message>
        <source>Show the whole range of values</source>
        <translation>Den ganzen Wertebereich zeigen</translation>
    </message>
    <message>
        <source>Set isovalue</source>
        <translation>Isowert setzen</translation>
    </message>
    <message>
        <source>Suggested isovalue</source>
        <translation>Vorgeschlagener Isowert</translation>
    </message>
    <message>
        <source>The surface consists of all points with this value.

Drag the line on the histogram (counts are logarithmic).
Wheel or arrow keys: fine steps (Shift: tenfold)
Double click: suggested isovalue
Alt+click or right click: add an isosurface there
Ctrl+wheel: zoom the value axis, middle drag: pan it</source>
        <translation>Die Fläche besteht aus allen Punkten mit diesem Wert.

Die Linie im Histogramm ziehen (die Anzahlen sind logarithmisch).
Rad oder Pfeiltasten: feine Schritte (Umschalt: zehnfach)
Doppelklick: vorgeschlagener Isowert
Alt+Klick oder Rechtsklick: dort eine Isofläche hinzufügen
Strg+Rad: Wertachse zoomen, Ziehen mit der mittleren Taste: verschieben</translation>
    </message>
    <message>
        <source>Add surface</source>
        <translation>Fläche hinzufügen</translation>
    </message>
    <message>
        <source>Add an isosurface outside the present ones, where the histogram suggests one (also: Alt+click on the histogram)</source>
        <translation>Eine Isofläche außerhalb der vorhandenen hinzufügen, wo das Histogramm eine vorschlägt (auch: Alt+Klick ins Histogramm)</translation>
    </message>
    <message>
        <source>At most %1 isosurfaces are possible</source>
        <translation>Höchstens %1 Isoflächen sind möglich</translation>
    </message>
    <message>
        <source>Add isosurface</source>
        <translation>Isofläche hinzufügen</translation>
    </message>
</context>
<context>
    <name>isolux::ui::LabelsPanel</name>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hide the labels selected in the list</source>
        <translation>Die in der Liste gewählten Labels ausblenden</translation>
    </message>
    <message>
        <source>Show only</source>
        <translation>Nur diese zeigen</translation>
    </message>
    <message>
        <source>Hide all but the selected labels</source>
        <translation>Alle außer den gewählten Labels ausblenden</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Show all labels but 0</source>
        <translation>Alle Labels außer 0 zeigen</translation>
    </message>
    <message>
        <source>Find a label</source>
        <translation>Label suchen</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Volume, mm³</source>
        <translation>Volumen, mm³</translation>
    </message>
    <message>
        <source>Labels of the volume</source>
        <translation>Labels des Volumens</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Hide labels</source>
        <translation>Labels ausblenden</translation>
    </message>
    <message>
        <source>Show only labels</source>
        <translation>Nur diese Labels zeigen</translation>
    </message>
    <message>
        <source>Show all labels</source>
        <translation>Alle Labels zeigen</translation>
    </message>
    <message>
        <source>Labels: %1</source>
        <translation>Labels: %1</translation>
    </message>
    <message>
        <source>The volume is no label map.</source>
        <translation>Das Volumen ist keine Labelkarte.</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>At least one label stays shown.</source>
        <translation>Mindestens ein Label bleibt sichtbar.</translation>
    </message>
    <message>
        <source>Own surface</source>
        <translation>Eigene Fläche</translation>
    </message>
    <message>
        <source>Give the selected labels a surface of their own, with its own opacity and colour</source>
        <translation>Den gewählten Labels eine eigene Fläche mit eigener Deckkraft und Farbe geben</translation>
    </message>
    <message>
        <source>Give labels a surface</source>
        <translation>Labels eine Fläche geben</translation>
    </message>
    <message>
        <source>At most %1 surfaces are possible</source>
        <translation>Höchstens %1 Flächen sind möglich</translation>
    </message>
</context>
<context>
    <name>isolux::ui::LevelMarks</name>
    <message>
        <source>Marking lost structure requires the volume’s index; the command “isolux index” creates it.</source>
        <translation>Zum Markieren verlorener Strukturen ist der Index des Volumens nötig; der Befehl „isolux index“ legt ihn an.</translation>
    </message>
    <message>
        <source>hides nothing in this view</source>
        <translation>verbirgt in dieser Ansicht nichts</translation>
    </message>
    <message>
        <source>Wherever the isosurface crosses the volume, the overview shows a surface at most one of its voxels away.</source>
        <translation>Überall, wo die Isofläche durch das Volumen geht, zeigt die Übersicht eine Fläche, höchstens um eines ihrer Voxel versetzt.</translation>
    </message>
    <message>
        <source>may hide structure in %1 % of the image</source>
        <translation>verbirgt vielleicht Strukturen in %1 % des Bildes</translation>
    </message>
    <message>
        <source>Hatched: the isosurface crosses the volume here, but the overview does not show it. Structures thinner than %1 may be missing.</source>
        <translation>Schraffiert: Hier geht die Isofläche durch das Volumen, aber die Übersicht zeigt sie nicht. Strukturen dünner als %1 können fehlen.</translation>
    </message>
</context>
<context>
    <name>isolux::ui::LightChooser</name>
    <message>
        <source>Light: %1</source>
        <translation>Licht: %1</translation>
    </message>
</context>
<context>
    <name>isolux::ui::LightStatus</name>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Stop computing light and keep the result so far</source>
        <translation>Lichtberechnung beenden und das bisherige Ergebnis behalten</translation>
    </message>
    <message>
        <source>Stop computing light</source>
        <translation>Lichtberechnung beenden</translation>
    </message>
    <message>
        <source>Resume computing light</source>
        <translation>Lichtberechnung fortsetzen</translation>
    </message>
    <message>
        <source>Pause computing light</source>
        <translation>Lichtberechnung pausieren</translation>
    </message>
</context>
<context>
    <name>isolux::ui::LoadCard</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1 …</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Preview: one voxel of each %1 × %2 × %3</source>
        <translation>Vorschau: ein Voxel von je %1 × %2 × %3</translation>
    </message>
    <message>
        <source>Preview from the index: blocks of %1 × %2 × %3 voxels</source>
        <translation>Vorschau aus dem Index: Blöcke von %1 × %2 × %3 Voxeln</translation>
    </message>
</context>
<context>
    <name>isolux::ui::LooksPanel</name>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Darstellungen</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Shift of the preset&apos;s isovalues</source>
        <translation>Verschiebung der Isowerte der Vorlage</translation>
    </message>
    <message>
        <source>Does not apply: %1</source>
        <translation>Nicht anwendbar: %1</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>Vorlage %1</translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation>Darstellung %1</translation>
    </message>
    <message>
        <source>Shifts the isovalues of %1</source>
        <translation>Verschiebt die Isowerte von %1</translation>
    </message>
    <message>
        <source>Choose a preset to shift its isovalues</source>
        <translation>Eine Vorlage wählen, um ihre Isowerte zu verschieben</translation>
    </message>
    <message>
        <source>Shift preset %1</source>
        <translation>Vorlage %1 verschieben</translation>
    </message>
</context>
<context>
    <name>isolux::ui::MainWindow</name>
    <message>
        <source>%1 (%2 in the Volume panel)</source>
        <translation>%1 (%2 im Bedienfeld Volumen)</translation>
    </message>
    <message>
        <source>also</source>
        <translation>auch</translation>
    </message>
    <message>
        <source>all %1 warnings</source>
        <translation>alle %1 Warnungen</translation>
    </message>
    <message>
        <source>Light is computed again for a rotatable environment; after that, turning it needs no new computation</source>
        <translation>Das Licht wird für eine drehbare Umgebung neu berechnet; danach kostet Drehen keine Rechenzeit</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Stop &amp;recording</source>
        <translation>Aufzeichnung &amp;beenden</translation>
    </message>
    <message>
        <source>Start &amp;recording…</source>
        <translation>Aufzeichnung &amp;beginnen …</translation>
    </message>
    <message>
        <source>● Recording</source>
        <translation>● Aufzeichnung</translation>
    </message>
    <message>
        <source>Change look</source>
        <translation>Darstellung ändern</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>About Isolux</source>
        <translation>Über Isolux</translation>
    </message>
    <message>
        <source>Volumes, sessions and images (%1)</source>
        <translation>Volumen, Sitzungen und Bilder (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Save image</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Save recording as</source>
        <translation>Aufzeichnung speichern unter</translation>
    </message>
    <message>
        <source>render it with isolux replay %1 --out FOLDER</source>
        <translation>isolux replay %1 --out ORDNER macht Bilder daraus</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>Save your work on %1 as a session?</source>
        <translation>Die Arbeit an %1 als Sitzung speichern?</translation>
    </message>
    <message>
        <source>A session stores isovalue, look, light and view, but not the baked light.</source>
        <translation>Eine Sitzung enthält Isowert, Darstellung, Licht und Ansicht, aber nicht das gespeicherte Licht.</translation>
    </message>
    <message>
        <source>An autosave could not be read. Its file is %1</source>
        <translation>Eine automatische Sicherung war nicht lesbar. Ihre Datei ist %1</translation>
    </message>
    <message>
        <source>Continue: %1, %2</source>
        <translation>Fortsetzen: %1, %2</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;List of measurements</source>
        <translation>&amp;Liste der Messungen</translation>
    </message>
    <message>
        <source>Show the Measure panel</source>
        <translation>Das Bedienfeld Messen zeigen</translation>
    </message>
    <message>
        <source>E&amp;xport measurements…</source>
        <translation>Messungen &amp;exportieren …</translation>
    </message>
    <message>
        <source>Save as a table (CSV) or for 3D Slicer (.mrk.json)</source>
        <translation>Als Tabelle (CSV) oder für 3D Slicer (.mrk.json) speichern</translation>
    </message>
    <message>
        <source>&amp;Import measurements…</source>
        <translation>Messungen &amp;importieren …</translation>
    </message>
    <message>
        <source>Open 3D Slicer markups (.mrk.json)</source>
        <translation>Markups von 3D Slicer öffnen (.mrk.json)</translation>
    </message>
    <message>
        <source>      κ₁ %1, κ₂ %2 /mm (confidence %3)</source>
        <translation>      κ₁ %1, κ₂ %2 /mm (Konfidenz %3)</translation>
    </message>
    <message>
        <source>unknown format for measurements; use .csv or .mrk.json</source>
        <translation>unbekanntes Format für Messungen; .csv oder .mrk.json verwenden</translation>
    </message>
    <message>
        <source>some measurements were not finished</source>
        <translation>einige Messungen waren nicht fertig</translation>
    </message>
    <message>
        <source>1 measurement from %1</source>
        <translation>1 Messung aus %1</translation>
    </message>
    <message>
        <source>%1 measurements from %2</source>
        <translation>%1 Messungen aus %2</translation>
    </message>
    <message>
        <source>skipped: %1</source>
        <translation>ausgelassen: %1</translation>
    </message>
    <message>
        <source>Import measurements</source>
        <translation>Messungen importieren</translation>
    </message>
    <message>
        <source>Export measurements</source>
        <translation>Messungen exportieren</translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json *.json);;All files (*)</source>
        <translation>Markups von 3D Slicer (*.mrk.json *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a volume, session or image</source>
        <translation>Volumen, Sitzung oder Bild öffnen</translation>
    </message>
    <message>
        <source>Open &amp;folder (DICOM)…</source>
        <translation>&amp;Ordner öffnen (DICOM) …</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files or numbered images</source>
        <translation>Ordner mit DICOM-Dateien oder nummerierten Bildern öffnen</translation>
    </message>
    <message>
        <source>Open re&amp;cent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open built-in &amp;phantom</source>
        <translation>Eingebautes &amp;Phantom öffnen</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>Sitzung &amp;speichern</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Sitzung speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the session elsewhere</source>
        <translation>Sitzung an anderem Ort speichern</translation>
    </message>
    <message>
        <source>Save &amp;image…</source>
        <translation>B&amp;ild speichern …</translation>
    </message>
    <message>
        <source>Save the image</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Path-&amp;trace image…</source>
        <translation>Bild mit Pfad&amp;verfolgung …</translation>
    </message>
    <message>
        <source>Path-trace this view as a reference image without baked light</source>
        <translation>Diese Ansicht als Referenzbild ohne gespeichertes Licht berechnen</translation>
    </message>
    <message>
        <source>Record every change for `isolux replay`</source>
        <translation>Jede Änderung für `isolux replay` aufzeichnen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Be&amp;enden</translation>
    </message>
    <message>
        <source>Quit Isolux</source>
        <translation>Isolux beenden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Copy as command &amp;line</source>
        <translation>Als &amp;Befehlszeile kopieren</translation>
    </message>
    <message>
        <source>Copy a shell command that renders this image</source>
        <translation>Einen Befehl kopieren, der dieses Bild rendert</translation>
    </message>
    <message>
        <source>&amp;Find a setting</source>
        <translation>Einstellung &amp;suchen</translation>
    </message>
    <message>
        <source>Find a setting by its name</source>
        <translation>Eine Einstellung nach ihrem Namen suchen</translation>
    </message>
    <message>
        <source>Set memory, threads and speed for this computer</source>
        <translation>Speicher, Threads und Tempo dieses Rechners einstellen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation>Ansicht &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Reset the view</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Zoom to &amp;fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Fit the volume into the view</source>
        <translation>Das Volumen in die Ansicht einpassen</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>&amp;Orthographisch</translation>
    </message>
    <message>
        <source>Switch between perspective and orthographic projection</source>
        <translation>Zwischen perspektivischer und orthographischer Projektion wechseln</translation>
    </message>
    <message>
        <source>&amp;Next look</source>
        <translation>&amp;Nächste Darstellung</translation>
    </message>
    <message>
        <source>Next look</source>
        <translation>Nächste Darstellung</translation>
    </message>
    <message>
        <source>Pre&amp;vious look</source>
        <translation>&amp;Vorige Darstellung</translation>
    </message>
    <message>
        <source>Previous look</source>
        <translation>Vorige Darstellung</translation>
    </message>
    <message>
        <source>&amp;Animate flow</source>
        <translation>Strömung &amp;bewegen</translation>
    </message>
    <message>
        <source>Start or stop the flow animation</source>
        <translation>Strömung bewegen oder anhalten</translation>
    </message>
    <message>
        <source>Full &amp;screen</source>
        <translation>Vollbil&amp;d</translation>
    </message>
    <message>
        <source>Switch to full screen; Esc leaves it</source>
        <translation>Auf Vollbild wechseln; Esc verlässt es</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>Von %1</translation>
    </message>
    <message>
        <source>From %1 (%2)</source>
        <translation>Von %1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>&amp;About Isolux</source>
        <translation>&amp;Über Isolux</translation>
    </message>
    <message>
        <source>Version and graphics</source>
        <translation>Version und Grafik</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Pins and measurements: P, M, Shift+M</source>
        <translation>Pins und Messungen: P, M, Umschalt+M</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Look: what the colours show (L, Shift+L: next, previous)</source>
        <translation>Darstellung: was die Farben zeigen (L, Umschalt+L: nächste, vorige)</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>&amp;Hide this piece</source>
        <translation>Dieses Teil &amp;ausblenden</translation>
    </message>
    <message>
        <source>Hide piece</source>
        <translation>Teil ausblenden</translation>
    </message>
    <message>
        <source>Show &amp;only this piece</source>
        <translation>&amp;Nur dieses Teil zeigen</translation>
    </message>
    <message>
        <source>Show only one piece</source>
        <translation>Nur ein Teil zeigen</translation>
    </message>
    <message>
        <source>&amp;Keep the largest piece</source>
        <translation>Größtes Teil &amp;behalten</translation>
    </message>
    <message>
        <source>Keep the largest piece</source>
        <translation>Größtes Teil behalten</translation>
    </message>
    <message>
        <source>Show &amp;all pieces</source>
        <translation>A&amp;lle Teile zeigen</translation>
    </message>
    <message>
        <source>Show all pieces</source>
        <translation>Alle Teile zeigen</translation>
    </message>
    <message>
        <source>&amp;List the pieces</source>
        <translation>Teile aufli&amp;sten</translation>
    </message>
    <message>
        <source>&amp;Presets</source>
        <translation>V&amp;orlagen</translation>
    </message>
    <message>
        <source>Apply a preset: isovalues, look and light for one kind of data</source>
        <translation>Eine Vorlage anwenden: Isowerte, Darstellung und Licht für eine Art von Daten</translation>
    </message>
    <message>
        <source>Does not apply: %1</source>
        <translation>Nicht anwendbar: %1</translation>
    </message>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>Als Vorlage &amp;speichern …</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>Vorlage %1</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Als Vorlage speichern</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>Name der Vorlage:</translation>
    </message>
    <message>
        <source>Copied a command that renders this image</source>
        <translation>Befehl kopiert, der dieses Bild rendert</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>ein Volumen</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Isolux %1&lt;/h3&gt;&lt;p&gt;Explore scans and simulations as isosurfaces, drawn directly from the voxels.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not a medical device: not for diagnosis.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Free software under the &lt;a href=&quot;https://opensource.org/license/bsd-3-clause&quot;&gt;BSD 3-Clause licence&lt;/a&gt;, without any warranty.&lt;/p&gt;&lt;p&gt;Graphics: %2&lt;/p&gt;&lt;p&gt;Qt %3&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Isolux %1&lt;/h3&gt;&lt;p&gt;Scans und Simulationen als Isoflächen erkunden, gezeichnet direkt aus den Voxeln.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Kein Medizinprodukt: nicht zur Diagnose.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Freie Software unter der &lt;a href=&quot;https://opensource.org/license/bsd-3-clause&quot;&gt;BSD-3-Klausel-Lizenz&lt;/a&gt;, ohne jede Gewährleistung.&lt;/p&gt;&lt;p&gt;Grafik: %2&lt;/p&gt;&lt;p&gt;Qt %3&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Schneiden</translation>
    </message>
    <message>
        <source>Saved %1, %2</source>
        <translation>%1 gespeichert, %2</translation>
    </message>
    <message>
        <source>anonymous</source>
        <translation>anonym</translation>
    </message>
    <message>
        <source>Follow linked view</source>
        <translation>Gekoppelter Ansicht folgen</translation>
    </message>
    <message>
        <source>&amp;New window</source>
        <translation>&amp;Neues Fenster</translation>
    </message>
    <message>
        <source>Open another window, to compare volumes</source>
        <translation>Ein weiteres Fenster öffnen, um Volumen zu vergleichen</translation>
    </message>
    <message>
        <source>&amp;DICOM browser…</source>
        <translation>&amp;DICOM-Browser …</translation>
    </message>
    <message>
        <source>Choose from the patients, studies and series of a folder or disc</source>
        <translation>Aus den Patienten, Studien und Serien eines Ordners oder Datenträgers wählen</translation>
    </message>
    <message>
        <source>Export &amp;mesh…</source>
        <translation>Netz e&amp;xportieren …</translation>
    </message>
    <message>
        <source>Export the isosurface as triangles, for 3-D printing and simulation</source>
        <translation>Die Isofläche als Dreiecke exportieren, für 3D-Druck und Simulation</translation>
    </message>
    <message>
        <source>&amp;Copy image</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the image with the options of Save image</source>
        <translation>Das Bild mit den Optionen von „Bild speichern“ kopieren</translation>
    </message>
    <message>
        <source>Lin&amp;k views of windows</source>
        <translation>Ansichten der Fenster &amp;koppeln</translation>
    </message>
    <message>
        <source>&amp;Copy view to other windows</source>
        <translation>Ansicht &amp;in andere Fenster kopieren</translation>
    </message>
    <message>
        <source>Show the volumes of all other windows from this view</source>
        <translation>Die Volumen aller anderen Fenster in dieser Ansicht zeigen</translation>
    </message>
    <message>
        <source>&amp;Hide patient data</source>
        <translation>&amp;Patientendaten verbergen</translation>
    </message>
    <message>
        <source>Show name, ID and birth date as “anonymous”</source>
        <translation>Name, Kennung und Geburtsdatum als „anonym“ zeigen</translation>
    </message>
    <message>
        <source>Guided &amp;tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>Take a two-minute tour of the window</source>
        <translation>Das Fenster in zwei Minuten kennenlernen</translation>
    </message>
    <message>
        <source>Use the one in %1</source>
        <translation>Die Datei in %1 verwenden</translation>
    </message>
    <message>
        <source>Find it…</source>
        <translation>Suchen …</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Wo ist %1?</translation>
    </message>
    <message>
        <source>%1 shows %2, which is neither in its previous folder nor next to the session. Where is it now?</source>
        <translation>%1 zeigt %2; diese Datei liegt weder im früheren Ordner noch neben der Sitzung. Wo ist sie jetzt?</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>ein Ordner</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>, with session</source>
        <translation>, mit Sitzung</translation>
    </message>
    <message>
        <source>PNG%1 (*.png)</source>
        <translation>PNG%1 (*.png)</translation>
    </message>
    <message>
        <source>OpenEXR, linear colours%1 (*.exr)</source>
        <translation>OpenEXR, lineare Farben%1 (*.exr)</translation>
    </message>
    <message>
        <source>Change image annotations</source>
        <translation>Bildbeschriftung ändern</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>The image was not saved (cancelled)</source>
        <translation>Das Bild wurde nicht gespeichert (abgebrochen)</translation>
    </message>
    <message>
        <source>Copying the image</source>
        <translation>Das Bild wird kopiert</translation>
    </message>
    <message>
        <source>Copied the image: %1 × %2 pixels</source>
        <translation>Bild kopiert: %1 × %2 Pixel</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>STL, for printing (*.stl)</source>
        <translation>STL, zum Drucken (*.stl)</translation>
    </message>
    <message>
        <source>PLY, with normals (*.ply)</source>
        <translation>PLY, mit Normalen (*.ply)</translation>
    </message>
    <message>
        <source>Wavefront OBJ (*.obj)</source>
        <translation>Wavefront OBJ (*.obj)</translation>
    </message>
    <message>
        <source>VTK, with curvature (*.vtp)</source>
        <translation>VTK, mit Krümmung (*.vtp)</translation>
    </message>
    <message>
        <source>Move crosshair</source>
        <translation>Fadenkreuz bewegen</translation>
    </message>
    <message>
        <source>Start tour</source>
        <translation>Rundgang beginnen</translation>
    </message>
    <message>
        <source>Got it</source>
        <translation>Verstanden</translation>
    </message>
    <message>
        <source>Welcome to Isolux</source>
        <translation>Willkommen bei Isolux</translation>
    </message>
    <message>
        <source>&lt;ul style=&apos;margin-left:-24px&apos;&gt;&lt;li&gt;Drag in the view to rotate it; the wheel zooms.&lt;/li&gt;&lt;li&gt;Drag the line in the histogram below to choose the surface.&lt;/li&gt;&lt;li&gt;To open your own scan, drop its file or folder here, or press Ctrl+O.&lt;/li&gt;&lt;/ul&gt;</source>
        <translation>&lt;ul style=&apos;margin-left:-24px&apos;&gt;&lt;li&gt;In der Ansicht ziehen, um sie zu drehen; das Rad zoomt.&lt;/li&gt;&lt;li&gt;Die Linie im Histogramm darunter ziehen, um die Fläche zu wählen.&lt;/li&gt;&lt;li&gt;Einen eigenen Scan öffnen: Datei oder Ordner hierher ziehen oder Strg+O drücken.&lt;/li&gt;&lt;/ul&gt;</translation>
    </message>
    <message>
        <source>Choose the surface</source>
        <translation>Die Fläche wählen</translation>
    </message>
    <message>
        <source>Drag the bright line in the histogram. The surface consists of all points with this value: in a CT, low values show skin, high ones bone.</source>
        <translation>Die helle Linie im Histogramm ziehen. Die Fläche besteht aus allen Punkten mit diesem Wert: im CT zeigen niedrige Werte Haut, hohe Knochen.</translation>
    </message>
    <message>
        <source>Rotate the view</source>
        <translation>Die Ansicht drehen</translation>
    </message>
    <message>
        <source>Drag with the left button to rotate, with the middle one to pan; the wheel zooms. Keys 1 to 6 show the six sides; R resets the view.</source>
        <translation>Mit der linken Taste ziehen dreht, mit der mittleren verschiebt; das Rad zoomt. Die Tasten 1 bis 6 zeigen die sechs Seiten; R setzt die Ansicht zurück.</translation>
    </message>
    <message>
        <source>Choose a look</source>
        <translation>Eine Darstellung wählen</translation>
    </message>
    <message>
        <source>This list sets what the colours show: the shaded surface, curvature, depth or global illumination. L selects the next look.</source>
        <translation>Diese Liste legt fest, was die Farben zeigen: die schattierte Fläche, Krümmung, Tiefe oder globale Beleuchtung. L wählt die nächste Darstellung.</translation>
    </message>
    <message>
        <source>Look inside</source>
        <translation>Hineinsehen</translation>
    </message>
    <message>
        <source>Press F4, or choose View &gt; Layout. The outline in each slice is the surface. Click in a slice to move the crosshair.</source>
        <translation>F4 drücken oder Ansicht &gt; Anordnung wählen. Die Linie in jeder Schicht ist die Fläche. Ein Klick in eine Schicht bewegt das Fadenkreuz.</translation>
    </message>
    <message>
        <source>Save the result</source>
        <translation>Das Ergebnis speichern</translation>
    </message>
    <message>
        <source>Save the image with this button, or Ctrl+E. It can show orientation labels, a scale bar and the isovalue, and opens again as a session. (You may also cancel.)</source>
        <translation>Das Bild mit diesem Knopf oder Strg+E speichern. Es kann Orientierungsbuchstaben, Maßstab und Isowert zeigen und lässt sich als Sitzung wieder öffnen. (Abbrechen geht auch.)</translation>
    </message>
    <message>
        <source>End of the tour</source>
        <translation>Ende des Rundgangs</translation>
    </message>
    <message>
        <source>Presets set suitable isovalues for CT and MR. Ctrl+F finds every setting. F1 lists mouse and keys. You can undo every change.</source>
        <translation>Vorlagen setzen passende Isowerte für CT und MR. Strg+F findet jede Einstellung. F1 zeigt Maus und Tasten. Jede Änderung lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Overview: level %1</source>
        <translation>Übersicht: Stufe %1</translation>
    </message>
    <message>
        <source>&amp;Mark structure lost in the overview</source>
        <translation>Verlorene Strukturen der Übersicht &amp;markieren</translation>
    </message>
    <message>
        <source>Hatch where the coarser level shown may hide structure of the volume</source>
        <translation>Schraffieren, wo die gezeigte gröbere Stufe Strukturen des Volumens verbergen kann</translation>
    </message>
    <message>
        <source>Full resolution (level %1 in motion)</source>
        <translation>Volle Auflösung (in Bewegung Stufe %1)</translation>
    </message>
    <message>
        <source>&amp;Draw full resolution when idle</source>
        <translation>In R&amp;uhe volle Auflösung zeichnen</translation>
    </message>
    <message>
        <source>After the final image of a coarser level, draw full resolution from the file; creates an index if there is none</source>
        <translation>Nach dem fertigen Bild einer gröberen Stufe die volle Auflösung aus der Datei zeichnen; legt einen Index an, wenn keiner da ist</translation>
    </message>
    <message>
        <source>Parts missing</source>
        <translation>Teile fehlen</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Programmeinstellungen …</translation>
    </message>
    <message>
        <source>Link the views of all windows; untick it in a window to leave that window out</source>
        <translation>Die Ansichten aller Fenster koppeln; ein Fenster bleibt ausgenommen, wenn es dort abgewählt wird</translation>
    </message>
    <message>
        <source>Centre on mesh position</source>
        <translation>Auf Stelle des Netzes zentrieren</translation>
    </message>
    <message>
        <source>&amp;Reset all settings</source>
        <translation>Alle Einstellungen zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Light for this image takes about %1</source>
        <translation>Das Licht für dieses Bild braucht etwa %1</translation>
    </message>
    <message>
        <source>Compute light</source>
        <translation>Licht berechnen</translation>
    </message>
    <message>
        <source>&amp;Data: %1…</source>
        <translation>&amp;Daten: %1…</translation>
    </message>
    <message>
        <source>Lists the presets for this kind of data; choose another kind in the Volume panel</source>
        <translation>Zeigt die Vorlagen für diese Art von Daten; eine andere Art im Bedienfeld Volumen wählen</translation>
    </message>
    <message>
        <source>The documentation is not installed</source>
        <translation>Die Dokumentation ist nicht installiert</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>The documentation that comes with the program</source>
        <translation>Die mitgelieferte Dokumentation</translation>
    </message>
    <message>
        <source>Image &amp;quality</source>
        <translation>Bild&amp;qualität</translation>
    </message>
    <message>
        <source>&amp;Play time steps</source>
        <translation>Zeitschritte &amp;abspielen</translation>
    </message>
    <message>
        <source>Play or pause the time steps</source>
        <translation>Zeitschritte abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Change image quality</source>
        <translation>Bildqualität ändern</translation>
    </message>
    <message>
        <source>%1   %2   %3 mm      voxel %4, %5, %6      %7</source>
        <translation>%1   %2   %3 mm      Voxel %4, %5, %6      %7</translation>
    </message>
    <message>
        <source>value %1</source>
        <translation>Wert %1</translation>
    </message>
</context>
<context>
    <name>isolux::ui::MarksPanel</name>
    <message>
        <source>No measurements yet.

Choose a tool from the Measure menu, then click on the surface: pin (P), distance (M), geodesic distance (Shift+M), angle, circle, thickness or piece.</source>
        <translation>Noch keine Messungen.

Ein Werkzeug aus dem Menü Messen wählen, dann auf die Oberfläche klicken: Pin (P), Abstand (M), geodätischer Abstand (Umschalt+M), Winkel, Kreis, Dicke oder Teil.</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Messung läuft …</translation>
    </message>
    <message>
        <source>Measured values</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Colour of the measurement</source>
        <translation>Farbe der Messung</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete selected measurements (Del)</source>
        <translation>Gewählte Messungen löschen (Entf)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the values of all measurements as text</source>
        <translation>Werte aller Messungen als Text kopieren</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export …</translation>
    </message>
    <message>
        <source>Save the measurements as a table (CSV) or for 3D Slicer (.mrk.json)</source>
        <translation>Messungen als Tabelle (CSV) oder für 3D Slicer (.mrk.json) speichern</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Import …</translation>
    </message>
    <message>
        <source>Open 3D Slicer markups (.mrk.json)</source>
        <translation>Markups von 3D Slicer öffnen (.mrk.json)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop measuring</source>
        <translation>Messung anhalten</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Double click: rename; box: show in the view</source>
        <translation>Doppelklick: umbenennen; Kästchen: in der Ansicht zeigen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>Rename measurement</source>
        <translation>Messung umbenennen</translation>
    </message>
    <message>
        <source>Colour measurements</source>
        <translation>Messungen färben</translation>
    </message>
    <message>
        <source>Delete measurement</source>
        <translation>Messung löschen</translation>
    </message>
    <message>
        <source>Delete measurements</source>
        <translation>Messungen löschen</translation>
    </message>
    <message>
        <source>Measure anyway</source>
        <translation>Trotzdem messen</translation>
    </message>
    <message>
        <source>Measure with voxels of 1 mm, which may be wrong: the file states no voxel size</source>
        <translation>Mit Voxeln von 1 mm messen, was falsch sein kann: Die Datei gibt keine Voxelgröße an</translation>
    </message>
</context>
<context>
    <name>isolux::ui::MeshDialog</name>
    <message>
        <source>&amp;Cap openings at the volume border</source>
        <translation>Öffnungen am Rand des Volumens &amp;schließen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>No subdivision</source>
        <translation>Keine Unterteilung</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Largest deviation from the surface: triangles are split until they meet it</source>
        <translation>Größte Abweichung von der Fläche: Dreiecke werden geteilt, bis sie eingehalten ist</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Isovalue</source>
        <translation>Isowert</translation>
    </message>
    <message>
        <source>Exports the surface as shown, without hidden pieces. The extension sets the format: .stl, .ply, .obj or .vtp. A .vtp file also contains curvature and the values of a second volume.</source>
        <translation>Exportiert die Fläche, wie sie gezeigt wird, ohne verborgene Teile. Die Endung bestimmt das Format: .stl, .ply, .obj oder .vtp. Eine .vtp-Datei enthält auch Krümmung und die Werte eines zweiten Volumens.</translation>
    </message>
    <message>
        <source>%1 Cuts are ignored: the whole surface is exported.</source>
        <translation>%1 Schnitte bleiben unbeachtet: die ganze Fläche wird exportiert.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Writing %1…</source>
        <translation>%1 wird geschrieben …</translation>
    </message>
    <message>
        <source>Writing %1… %2</source>
        <translation>%1 wird geschrieben … %2</translation>
    </message>
    <message>
        <source>Stopped: nothing was written.</source>
        <translation>Angehalten: nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Saved %1: %2.</source>
        <translation>%1 gespeichert: %2.</translation>
    </message>
    <message>
        <source>Saved %1: %2. %3.</source>
        <translation>%1 gespeichert: %2. %3.</translation>
    </message>
    <message>
        <source>Sho&amp;w largest deviation</source>
        <translation>Größte A&amp;bweichung zeigen</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>unknown until export</source>
        <translation>vor dem Export unbekannt</translation>
    </message>
    <message>
        <source>%1 or more, depending on the tolerance</source>
        <translation>%1 oder mehr, je nach Toleranz</translation>
    </message>
</context>
<context>
    <name>isolux::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>isolux::ui::ObliqueDialog</name>
    <message>
        <source>Oblique slice</source>
        <translation>Schräge Schicht</translation>
    </message>
    <message>
        <source>Point (mm)</source>
        <translation>Punkt (mm)</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>The crosshair moves to the point. The plane is perpendicular to the normal and follows the crosshair.</source>
        <translation>Das Fadenkreuz rückt auf den Punkt. Die Ebene steht senkrecht zur Normalen und folgt dem Fadenkreuz.</translation>
    </message>
</context>
<context>
    <name>isolux::ui::PassesPanel</name>
    <message>
        <source>No image yet</source>
        <translation>Noch kein Bild</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the table as text, for a document or a spreadsheet</source>
        <translation>Die Tabelle als Text kopieren, für ein Dokument oder eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Passes of the last image</source>
        <translation>Durchgänge des letzten Bildes</translation>
    </message>
    <message>
        <source>Last run took %1</source>
        <translation>Letzter Lauf: %1</translation>
    </message>
    <message>
        <source>on the CPU: %1</source>
        <translation>auf der CPU: %1</translation>
    </message>
    <message>
        <source>Redrawn once since, with all passes cached.</source>
        <translation>Seither einmal neu gezeichnet, alle Durchgänge zwischengespeichert.</translation>
    </message>
    <message>
        <source>Redrawn %1 times since, with all passes cached.</source>
        <translation>Seither %1-mal neu gezeichnet, alle Durchgänge zwischengespeichert.</translation>
    </message>
    <message>
        <source>Graphics memory: %1</source>
        <translation>Grafikspeicher: %1</translation>
    </message>
    <message>
        <source>Active blocks: %1 of %2 (%3 %)</source>
        <translation>Aktive Blöcke: %1 von %2 (%3 %)</translation>
    </message>
    <message>
        <source>Display: %1</source>
        <translation>Anzeige: %1</translation>
    </message>
</context>
<context>
    <name>isolux::ui::PictureDialog</name>
    <message>
        <source>Save image</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>&amp;Orientation labels</source>
        <translation>&amp;Orientierungsbuchstaben</translation>
    </message>
    <message>
        <source>Side of the patient at each edge, if the patient orientation is known</source>
        <translation>Seite des Patienten an jedem Rand, wenn die Orientierung des Patienten bekannt ist</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>Bar of a round length in millimetres</source>
        <translation>Maßstab von runder Länge in Millimetern</translation>
    </message>
    <message>
        <source>&amp;Isovalue</source>
        <translation>&amp;Isowert</translation>
    </message>
    <message>
        <source>Isovalues of the surfaces shown, with their unit</source>
        <translation>Isowerte der gezeigten Flächen mit ihrer Einheit</translation>
    </message>
    <message>
        <source>Le&amp;gend</source>
        <translation>Le&amp;gende</translation>
    </message>
    <message>
        <source>Meaning of the colours; also shown in the window</source>
        <translation>Bedeutung der Farben; auch im Fenster gezeigt</translation>
    </message>
    <message>
        <source>The colours of this look show no quantity</source>
        <translation>Die Farben dieser Darstellung zeigen keine Größe</translation>
    </message>
    <message>
        <source>Size and background</source>
        <translation>Größe und Hintergrund</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Wie im Fenster</translation>
    </message>
    <message>
        <source>2×</source>
        <translation>2×</translation>
    </message>
    <message>
        <source>4×</source>
        <translation>4×</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene Größe</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>Surface only, with anti-aliased edges, for slides and posters</source>
        <translation>Nur die Fläche, mit geglätteten Rändern, für Folien und Poster</translation>
    </message>
    <message>
        <source>File contents</source>
        <translation>Inhalt der Datei</translation>
    </message>
    <message>
        <source>Embed &amp;session</source>
        <translation>&amp;Sitzung einbetten</translation>
    </message>
    <message>
        <source>The image opens again as a session: view, isovalue, look, measurements</source>
        <translation>Das Bild lässt sich als Sitzung öffnen: Ansicht, Isowert, Darstellung, Messungen</translation>
    </message>
    <message>
        <source>Include full &amp;paths</source>
        <translation>Volle &amp;Pfade aufnehmen</translation>
    </message>
    <message>
        <source>Stores the folders of its files, which may identify you or the patient. Without them, the image opens as a session on this computer or next to its volume.</source>
        <translation>Nimmt die Ordner der Dateien auf, die Sie oder den Patienten erkennen lassen können. Ohne sie öffnet sich das Bild als Sitzung auf diesem Rechner oder neben seinem Volumen.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>Sp&amp;eichern …</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy to the clipboard, without the session</source>
        <translation>In die Zwischenablage kopieren, ohne die Sitzung</translation>
    </message>
    <message>
        <source>&amp;Hidden and interpolated data</source>
        <translation>&amp;Verborgene und interpolierte Daten</translation>
    </message>
    <message>
        <source>Lists hidden pieces and interpolated slices</source>
        <translation>Nennt verborgene Teile und interpolierte Schichten</translation>
    </message>
</context>
<context>
    <name>isolux::ui::PictureDot</name>
    <message>
        <source>The image is final</source>
        <translation>Das Bild ist fertig</translation>
    </message>
    <message>
        <source>A finer image is being rendered</source>
        <translation>Ein feineres Bild wird gerendert</translation>
    </message>
    <message>
        <source>No image yet</source>
        <translation>Noch kein Bild</translation>
    </message>
    <message>
        <source>The image is final except for its light</source>
        <translation>Das Bild ist bis auf sein Licht fertig</translation>
    </message>
    <message>
        <source>Last render time: %1</source>
        <translation>Letzte Renderzeit: %1</translation>
    </message>
</context>
<context>
    <name>isolux::ui::PiecesPanel</name>
    <message>
        <source>Keep the largest</source>
        <translation>Größte behalten</translation>
    </message>
    <message>
        <source>Inside the body above</source>
        <translation>Im Körper über</translation>
    </message>
    <message>
        <source>Hide smaller than</source>
        <translation>Kleinere verbergen als</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Volume, mm³</source>
        <translation>Volumen, mm³</translation>
    </message>
    <message>
        <source>Box, mm</source>
        <translation>Quader, mm</translation>
    </message>
    <message>
        <source>Pieces of the isosurface, the largest first</source>
        <translation>Teile der Isofläche, das größte zuerst</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hide the pieces selected in the list</source>
        <translation>Die in der Liste gewählten Teile ausblenden</translation>
    </message>
    <message>
        <source>Show only</source>
        <translation>Nur diese</translation>
    </message>
    <message>
        <source>Hide all but the selected pieces</source>
        <translation>Alle außer den gewählten Teilen ausblenden</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Centre the view on the selected piece (double click)</source>
        <translation>Die Ansicht auf das gewählte Teil zentrieren (Doppelklick)</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Show all pieces again</source>
        <translation>Alle Teile wieder zeigen</translation>
    </message>
    <message>
        <source>… and %1 smaller ones</source>
        <translation>… und %1 kleinere</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>Volume %1 mm³</source>
        <translation>Volumen %1 mm³</translation>
    </message>
    <message>
        <source>Area %1 mm²</source>
        <translation>Fläche %1 mm²</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 Voxel</translation>
    </message>
    <message>
        <source>Extends beyond the data: volume and area cover the part within</source>
        <translation>Reicht über die Daten hinaus: Volumen und Fläche gelten für den Teil darin</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>Open a volume to list the pieces (connected components) of its isosurface.</source>
        <translation>Ein Volumen öffnen, um die Teile (zusammenhängenden Komponenten) seiner Isofläche aufzulisten.</translation>
    </message>
    <message>
        <source>Finding pieces… %1 %</source>
        <translation>Teile werden gesucht … %1 %</translation>
    </message>
    <message>
        <source>No voxel is inside at %1: change the isovalue.</source>
        <translation>Bei %1 liegt kein Voxel innen: den Isowert ändern.</translation>
    </message>
    <message>
        <source>One piece at %1</source>
        <translation>Ein Teil bei %1</translation>
    </message>
    <message>
        <source>%1 pieces at %2</source>
        <translation>%1 Teile bei %2</translation>
    </message>
    <message>
        <source>, %1 hidden</source>
        <translation>, %1 ausgeblendet</translation>
    </message>
    <message>
        <source> (of the first isosurface)</source>
        <translation> (der ersten Isofläche)</translation>
    </message>
    <message>
        <source> – measuring…</source>
        <translation> – Messung läuft …</translation>
    </message>
    <message>
        <source>Hide piece %1</source>
        <translation>Teil %1 ausblenden</translation>
    </message>
    <message>
        <source>Show piece %1</source>
        <translation>Teil %1 zeigen</translation>
    </message>
    <message>
        <source>Hide %1 pieces</source>
        <translation>%1 Teile ausblenden</translation>
    </message>
    <message>
        <source>Show only piece %1</source>
        <translation>Nur Teil %1 zeigen</translation>
    </message>
    <message>
        <source>Show only %1 pieces</source>
        <translation>Nur %1 Teile zeigen</translation>
    </message>
    <message>
        <source>Centre on piece</source>
        <translation>Auf Teil zentrieren</translation>
    </message>
    <message>
        <source>Show all pieces</source>
        <translation>Alle Teile zeigen</translation>
    </message>
</context>
<context>
    <name>isolux::ui::PlanesWidget</name>
    <message>
        <source>Add a plane</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Add a copy of the last plane, or a plane across the z axis through the origin. The Cut menu adds planes through the view’s target.</source>
        <translation>Eine Kopie der letzten Ebene oder eine Ebene quer zur z-Achse durch den Ursprung hinzufügen. Das Menü Schneiden fügt Ebenen durch das Ziel der Ansicht hinzu.</translation>
    </message>
    <message>
        <source>%1 at</source>
        <translation>%1 bei</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Plane %1, %2 of its point, mm</source>
        <translation>Ebene %1, %2 ihres Punktes, mm</translation>
    </message>
    <message>
        <source>Plane %1, %2 of its normal</source>
        <translation>Ebene %1, %2 ihrer Normalen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove plane %1</source>
        <translation>Ebene %1 entfernen</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Reverse plane %1: cut away the other side</source>
        <translation>Ebene %1 umkehren: die andere Seite wegschneiden</translation>
    </message>
</context>
<context>
    <name>isolux::ui::PointedPiece</name>
    <message>
        <source>the largest of %1</source>
        <translation>das größte von %1</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>piece %1 (%2): %3</source>
        <translation>Teil %1 (%2): %3</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 Voxel</translation>
    </message>
</context>
<context>
    <name>isolux::ui::PointsEditor</name>
    <message>
        <source>Colour of the selected point</source>
        <translation>Farbe des gewählten Punktes</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Remove the selected point</source>
        <translation>Gewählten Punkt entfernen</translation>
    </message>
    <message>
        <source>Remove the selected point (Delete)</source>
        <translation>Gewählten Punkt entfernen (Entf)</translation>
    </message>
</context>
<context>
    <name>isolux::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Programmeinstellungen</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Stored on this computer only, not in sessions or recordings.</source>
        <translation>Nur auf diesem Rechner gespeichert, nicht in Sitzungen oder Aufzeichnungen.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Systemstandard</translation>
    </message>
    <message>
        <source>Language of the window; takes effect after a restart.</source>
        <translation>Sprache des Fensters; wird nach einem Neustart wirksam.</translation>
    </message>
    <message>
        <source>Takes effect after a restart.</source>
        <translation>Wird nach einem Neustart wirksam.</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>The background of the image is a setting of the scene.</source>
        <translation>Der Hintergrund des Bildes ist eine Einstellung der Szene.</translation>
    </message>
    <message>
        <source>Text and control size</source>
        <translation>Größe von Text und Bedienelementen</translation>
    </message>
    <message>
        <source>Multiplies the scaling of the screen.</source>
        <translation>Multipliziert die Skalierung des Bildschirms.</translation>
    </message>
    <message>
        <source>Patient’s name, ID and birth date</source>
        <translation>Name, Kennung und Geburtsdatum des Patienten</translation>
    </message>
    <message>
        <source>Hide on the &amp;screen</source>
        <translation>Auf dem &amp;Bildschirm verbergen</translation>
    </message>
    <message>
        <source>Hide in sa&amp;ved files: images, measurements, recordings</source>
        <translation>In &amp;gespeicherten Dateien verbergen: Bilder, Messungen, Aufzeichnungen</translation>
    </message>
    <message>
        <source>Applies to titles, the Volume panel, the DICOM browser and recent files</source>
        <translation>Gilt für Titel, das Bedienfeld Volumen, den DICOM-Browser und zuletzt geöffnete Dateien</translation>
    </message>
    <message>
        <source>Applies to sessions embedded in images, exported measurements, recordings and proposed file names. Session files always name the files that they open.</source>
        <translation>Gilt für in Bilder eingebettete Sitzungen, exportierte Messungen, Aufzeichnungen und vorgeschlagene Dateinamen. Sitzungsdateien nennen immer die Dateien, die sie öffnen.</translation>
    </message>
</context>
<context>
    <name>isolux::ui::RawImportDialog</name>
    <message>
        <source>Open raw file – %1</source>
        <translation>Rohdatei öffnen – %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; has no header that Isolux can read. How are its voxels stored?</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; hat keinen Kopf, den Isolux lesen kann. Wie sind die Voxel gespeichert?</translation>
    </message>
    <message>
        <source>no match by name or size</source>
        <translation>kein Treffer nach Name oder Größe</translation>
    </message>
    <message>
        <source>choose…</source>
        <translation>wählen …</translation>
    </message>
    <message>
        <source>little endian</source>
        <translation>Little-Endian</translation>
    </message>
    <message>
        <source>big endian</source>
        <translation>Big-Endian</translation>
    </message>
    <message>
        <source>Voxels along %1</source>
        <translation>Voxel entlang %1</translation>
    </message>
    <message>
        <source>Spacing along %1</source>
        <translation>Voxelabstand entlang %1</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Byte</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Vorschläge</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Bytefolge</translation>
    </message>
    <message>
        <source>Header</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Spacing, mm</source>
        <translation>Voxelabstand, mm</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>slice 9999 of 9999</source>
        <translation>Schicht 9999 von 9999</translation>
    </message>
    <message>
        <source>%1 bytes described, the file has %2.</source>
        <translation>%1 Byte beschrieben, die Datei hat %2.</translation>
    </message>
    <message>
        <source>They match.</source>
        <translation>Das passt.</translation>
    </message>
    <message>
        <source>The last %1 would be ignored.</source>
        <translation>Die letzten %1 blieben unbeachtet.</translation>
    </message>
    <message>
        <source>%1 are missing.</source>
        <translation>%1 fehlen.</translation>
    </message>
    <message>
        <source>slice %1 of %2</source>
        <translation>Schicht %1 von %2</translation>
    </message>
    <message>
        <source>This slice is beyond the end of the file.</source>
        <translation>Diese Schicht liegt hinter dem Ende der Datei.</translation>
    </message>
</context>
<context>
    <name>isolux::ui::RecentMenu</name>
    <message>
        <source>No recent files</source>
        <translation>Keine zuletzt geöffneten Dateien</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Diese Liste leeren</translation>
    </message>
</context>
<context>
    <name>isolux::ui::RecentPictures</name>
    <message>
        <source>Recently opened</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
</context>
<context>
    <name>isolux::ui::ReferenceDialog</name>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Paths per pixel</source>
        <translation>Pfade je Pixel</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Path-traced image</source>
        <translation>Bild mit Pfadverfolgung</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Noise (white: 10 % or more)</source>
        <translation>Rauschen (weiß: 10 % oder mehr)</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Traces every pixel independently, without baked light. Twice as many paths take twice the time; four times as many halve the noise.</source>
        <translation>Verfolgt jedes Pixel unabhängig, ohne gespeichertes Licht. Doppelt so viele Pfade brauchen doppelt so lange; viermal so viele halbieren das Rauschen.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>noise %1 %</source>
        <translation>Rauschen %1 %</translation>
    </message>
    <message>
        <source>Tracing…</source>
        <translation>Berechnung läuft …</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Save path-traced image</source>
        <translation>Bild mit Pfadverfolgung speichern</translation>
    </message>
    <message>
        <source>OpenEXR, linear colours, irradiance and variance (*.exr)</source>
        <translation>OpenEXR, lineare Farben, Bestrahlungsstärke und Varianz (*.exr)</translation>
    </message>
    <message>
        <source>PNG, with session (*.png)</source>
        <translation>PNG, mit Sitzung (*.png)</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>%1 wird gespeichert …</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
</context>
<context>
    <name>isolux::ui::SettingEditor</name>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Chosen automatically</source>
        <translation>Automatisch gewählt</translation>
    </message>
    <message>
        <source>Reset to default</source>
        <translation>Auf Standard zurücksetzen</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Has no effect: %1.</source>
        <translation>Ohne Wirkung: %1.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
</context>
<context>
    <name>isolux::ui::SettingsPanel</name>
    <message>
        <source>No matching setting.
Memory, threads and speed in motion are in Edit &gt; Preferences.</source>
        <translation>Keine passende Einstellung.
Speicher, Threads und Tempo bei Bewegung stehen unter Bearbeiten &gt; Programmeinstellungen.</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>Einstellung suchen</translation>
    </message>
    <message>
        <source>No setting in this group has an effect: %1</source>
        <translation>Keine Einstellung dieser Gruppe hat eine Wirkung: %1</translation>
    </message>
    <message>
        <source>Settings of the scene</source>
        <translation>Einstellungen der Szene</translation>
    </message>
</context>
<context>
    <name>isolux::ui::SliceView</name>
    <message>
        <source>Move crosshair</source>
        <translation>Fadenkreuz bewegen</translation>
    </message>
    <message>
        <source>Change window level and width</source>
        <translation>Fenstermitte und -breite ändern</translation>
    </message>
    <message>
        <source>Oblique slice</source>
        <translation>Schräge Schicht</translation>
    </message>
    <message>
        <source>Slice in clip plane %1</source>
        <translation>Schicht in Schnittebene %1</translation>
    </message>
    <message>
        <source>Move cut</source>
        <translation>Schnitt bewegen</translation>
    </message>
</context>
<context>
    <name>isolux::ui::SourcePanel</name>
    <message>
        <source>Mesh voxels</source>
        <translation>Voxel des Netzes</translation>
    </message>
    <message>
        <source>Boolean operation</source>
        <translation>Boolesche Operation</translation>
    </message>
    <message>
        <source>Second volume</source>
        <translation>Zweites Volumen</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Second isovalue</source>
        <translation>Zweiter Isowert</translation>
    </message>
    <message>
        <source>Choose the second volume</source>
        <translation>Das zweite Volumen wählen</translation>
    </message>
    <message>
        <source>Choose second volume</source>
        <translation>Zweites Volumen wählen</translation>
    </message>
    <message>
        <source>Second weight</source>
        <translation>Gewicht des zweiten Volumens</translation>
    </message>
</context>
<context>
    <name>isolux::ui::SurfaceList</name>
    <message>
        <source>Isosurfaces</source>
        <translation>Isoflächen</translation>
    </message>
    <message>
        <source>Show this isosurface</source>
        <translation>Diese Isofläche zeigen</translation>
    </message>
    <message>
        <source>Name of this isosurface</source>
        <translation>Name dieser Isofläche</translation>
    </message>
    <message>
        <source>Isovalue; arrow keys change it by one histogram step</source>
        <translation>Isowert; Pfeiltasten ändern ihn um einen Schritt des Histogramms</translation>
    </message>
    <message>
        <source>View-dependent opacity: transparent where the surface faces the viewer, dense where it is edge-on</source>
        <translation>Deckkraft nach Blickrichtung: durchsichtig, wo die Fläche zum Betrachter zeigt, dicht, wo sie von der Kante zu sehen ist</translation>
    </message>
    <message>
        <source>Remove this isosurface from the list</source>
        <translation>Diese Isofläche aus der Liste entfernen</translation>
    </message>
    <message>
        <source>Show isosurface</source>
        <translation>Isofläche zeigen</translation>
    </message>
    <message>
        <source>Hide isosurface</source>
        <translation>Isofläche verbergen</translation>
    </message>
    <message>
        <source>Colour of isosurface</source>
        <translation>Farbe der Isofläche</translation>
    </message>
    <message>
        <source>Rename isosurface</source>
        <translation>Isofläche umbenennen</translation>
    </message>
    <message>
        <source>Set isovalue</source>
        <translation>Isowert setzen</translation>
    </message>
    <message>
        <source>Opacity of isosurface</source>
        <translation>Deckkraft der Isofläche</translation>
    </message>
    <message>
        <source>Turn on view-dependent opacity</source>
        <translation>Deckkraft nach Blickrichtung einschalten</translation>
    </message>
    <message>
        <source>Turn off view-dependent opacity</source>
        <translation>Deckkraft nach Blickrichtung ausschalten</translation>
    </message>
    <message>
        <source>Remove isosurface</source>
        <translation>Isofläche entfernen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Name von %1</translation>
    </message>
    <message>
        <source>Isovalue of %1</source>
        <translation>Isowert von %1</translation>
    </message>
    <message>
        <source>Opacity of %1</source>
        <translation>Deckkraft von %1</translation>
    </message>
    <message>
        <source>Opacity: %1 %</source>
        <translation>Deckkraft: %1 %</translation>
    </message>
    <message>
        <source>View-dependent opacity of %1</source>
        <translation>Deckkraft nach Blickrichtung von %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Labels of this surface: numbers, ranges and names</source>
        <translation>Labels dieser Fläche: Zahlen, Bereiche und Namen</translation>
    </message>
    <message>
        <source>Choose labels of surface</source>
        <translation>Labels der Fläche wählen</translation>
    </message>
    <message>
        <source>others</source>
        <translation>übrige</translation>
    </message>
    <message>
        <source>Labels of %1</source>
        <translation>Labels von %1</translation>
    </message>
    <message>
        <source>Find a surface</source>
        <translation>Eine Fläche finden</translation>
    </message>
    <message>
        <source>Move surface</source>
        <translation>Fläche verschieben</translation>
    </message>
    <message>
        <source>Drag, or press the up and down keys, to move this surface in the list</source>
        <translation>Ziehen oder die Pfeiltasten drücken, um diese Fläche in der Liste zu verschieben</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Platz von %1</translation>
    </message>
</context>
<context>
    <name>isolux::ui::TargetBox</name>
    <message>
        <source>Error at most</source>
        <translation>Fehler höchstens</translation>
    </message>
    <message>
        <source>Time at most</source>
        <translation>Zeit höchstens</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Maximum time, milliseconds</source>
        <translation>Höchstzeit, Millisekunden</translation>
    </message>
    <message>
        <source>Kind of error</source>
        <translation>Art des Fehlers</translation>
    </message>
    <message>
        <source>Apply these settings as one undo step</source>
        <translation>Diese Einstellungen anwenden, als ein Schritt zum Rückgängigmachen</translation>
    </message>
    <message>
        <source>ms per image</source>
        <translation>ms je Bild</translation>
    </message>
    <message>
        <source>Keep %1 ms</source>
        <translation>%1 ms einhalten</translation>
    </message>
    <message>
        <source>Keep %1 %2</source>
        <translation>%1 %2 einhalten</translation>
    </message>
    <message>
        <source>Errors are known only for an uncut isosurface: remove the cuts or exclude it from them</source>
        <translation>Fehler sind nur für eine ungeschnittene Isofläche bekannt: die Schnitte entfernen oder sie davon ausnehmen</translation>
    </message>
    <message>
        <source>No settings achieve 0: enter a larger number</source>
        <translation>Keine Einstellungen erreichen 0: eine größere Zahl eingeben</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Find settings</source>
        <translation>Einstellungen suchen</translation>
    </message>
    <message>
        <source>Searching… %1 %</source>
        <translation>Suche … %1 %</translation>
    </message>
</context>
<context>
    <name>isolux::ui::Tour</name>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>isolux::ui::Viewport</name>
    <message>
        <source>3-D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Suggested isovalue</source>
        <translation>Vorgeschlagener Isowert</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Make it opaque</source>
        <translation>Deckend machen</translation>
    </message>
    <message>
        <source>%1.  Backspace removes the last point; Esc ends</source>
        <translation>%1.  Rücktaste entfernt den letzten Punkt; Esc beendet</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Zoom to fit</source>
        <translation>Ansicht einpassen</translation>
    </message>
    <message>
        <source>Orthographic view</source>
        <translation>Orthographische Ansicht</translation>
    </message>
    <message>
        <source>Perspective view</source>
        <translation>Perspektivische Ansicht</translation>
    </message>
    <message>
        <source>Cannot turn the environment: %1</source>
        <translation>Die Umgebung kann nicht gedreht werden: %1</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Centre on point</source>
        <translation>Auf Punkt zentrieren</translation>
    </message>
    <message>
        <source>Light %1: drag its outline to resize it</source>
        <translation>Lichtquelle %1: am Umriss ziehen, um die Größe zu ändern</translation>
    </message>
    <message>
        <source>Light %1: drag to move it; Ctrl+drag or wheel changes its distance</source>
        <translation>Lichtquelle %1: ziehen, um sie zu bewegen; Strg+Ziehen oder das Rad ändert die Entfernung</translation>
    </message>
    <message>
        <source>Resize light %1</source>
        <translation>Größe von Lichtquelle %1 ändern</translation>
    </message>
    <message>
        <source>Move light %1</source>
        <translation>Lichtquelle %1 bewegen</translation>
    </message>
    <message>
        <source>there is no image to save</source>
        <translation>es gibt kein Bild zu speichern</translation>
    </message>
    <message>
        <source>another image is being saved</source>
        <translation>ein anderes Bild wird gerade gespeichert</translation>
    </message>
    <message>
        <source>waiting for the image was cancelled</source>
        <translation>das Warten auf das Bild wurde abgebrochen</translation>
    </message>
    <message>
        <source>Show all pieces</source>
        <translation>Alle Teile zeigen</translation>
    </message>
    <message>
        <source>Remove the cuts</source>
        <translation>Schnitte entfernen</translation>
    </message>
    <message>
        <source>Plane %1: drag to turn it; Ctrl snaps to the axes and halfway between</source>
        <translation>Ebene %1: ziehen, um sie zu drehen; Strg rastet an den Achsen und halbwegs dazwischen ein</translation>
    </message>
    <message>
        <source>Plane %1: drag or use the wheel to move it along its normal; right click for the menu</source>
        <translation>Ebene %1: ziehen oder das Rad drehen, um sie längs ihrer Normalen zu bewegen; Rechtsklick für das Menü</translation>
    </message>
    <message>
        <source>Box: drag to turn it; Ctrl turns about one of its axes; right click for the menu</source>
        <translation>Quader: ziehen, um ihn zu drehen; Strg dreht um eine seiner Achsen; Rechtsklick für das Menü</translation>
    </message>
    <message>
        <source>Box: drag this face or use the wheel to move it</source>
        <translation>Quader: diese Seite ziehen oder das Rad drehen, um sie zu bewegen</translation>
    </message>
    <message>
        <source>Box: drag to move it parallel to the screen; right click for the menu</source>
        <translation>Quader: ziehen, um ihn parallel zum Bildschirm zu bewegen; Rechtsklick für das Menü</translation>
    </message>
    <message>
        <source>Turn plane %1</source>
        <translation>Ebene %1 drehen</translation>
    </message>
    <message>
        <source>Move plane %1</source>
        <translation>Ebene %1 bewegen</translation>
    </message>
    <message>
        <source>Turn the box</source>
        <translation>Quader drehen</translation>
    </message>
    <message>
        <source>Move a face of the box</source>
        <translation>Seite des Quaders bewegen</translation>
    </message>
    <message>
        <source>Move the box</source>
        <translation>Quader bewegen</translation>
    </message>
    <message>
        <source>Drawing the image</source>
        <translation>Das Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Images are copied through main memory: %1</source>
        <translation>Bilder werden über den Hauptspeicher kopiert: %1</translation>
    </message>
    <message>
        <source>The graphics driver was reset; the image is drawn again</source>
        <translation>Der Grafiktreiber wurde zurückgesetzt; das Bild wird neu gezeichnet</translation>
    </message>
</context>
<context>
    <name>isolux::ui::ViewportOverlay</name>
    <message>
        <source>%1 at the centre</source>
        <translation>%1 in der Mitte</translation>
    </message>
    <message>
        <source>The image cannot be drawn</source>
        <translation>Das Bild kann nicht gezeichnet werden</translation>
    </message>
</context>
<context>
    <name>isolux::ui::VolumePanel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Voxelabstand</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlend</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Import warnings</source>
        <translation>Importwarnungen</translation>
    </message>
    <message>
        <source>Choose series</source>
        <translation>Serie wählen</translation>
    </message>
    <message>
        <source>Choose channel</source>
        <translation>Kanal wählen</translation>
    </message>
    <message>
        <source>Choose time step</source>
        <translation>Zeitschritt wählen</translation>
    </message>
    <message>
        <source>read %1 s, prepared %2 s; first image %3 s after reading</source>
        <translation>gelesen %1 s, vorbereitet %2 s; erstes Bild %3 s nach dem Lesen</translation>
    </message>
    <message>
        <source>%1, in memory as %2</source>
        <translation>%1, im Speicher als %2</translation>
    </message>
    <message>
        <source>value = %1 · stored</source>
        <translation>Wert = %1 · gespeichert</translation>
    </message>
    <message>
        <source>%1; left-handed</source>
        <translation>%1; linkshändig</translation>
    </message>
    <message>
        <source>orientation not stated</source>
        <translation>Orientierung nicht angegeben</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 Voxel</translation>
    </message>
    <message>
        <source>read %1 s, prepared %2 s</source>
        <translation>gelesen %1 s, vorbereitet %2 s</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>About the volume</source>
        <translation>Über das Volumen</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Choose level</source>
        <translation>Stufe wählen</translation>
    </message>
    <message>
        <source>Level 0 is full resolution; each further level halves it along each axis, by averaging voxels</source>
        <translation>Stufe 0 ist die volle Auflösung; jede weitere Stufe halbiert sie je Achse durch Mittelung der Voxel</translation>
    </message>
    <message>
        <source> (slices %1 mm apart)</source>
        <translation> (Schichten im Abstand von %1 mm)</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Choose kind of data</source>
        <translation>Art der Daten wählen</translation>
    </message>
    <message>
        <source>%1 (automatic)</source>
        <translation>%1 (automatisch)</translation>
    </message>
    <message>
        <source>Kind of data; presets depend on it. Chosen because %1</source>
        <translation>Art der Daten; die Vorlagen hängen davon ab. Grund: %1</translation>
    </message>
    <message>
        <source>A fraction blends a step with the next</source>
        <translation>Ein Bruchteil blendet einen Schritt in den nächsten</translation>
    </message>
    <message>
        <source> steps per second</source>
        <translation> Schritte pro Sekunde</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Play time steps</source>
        <translation>Zeitschritte abspielen</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> von %1</translation>
    </message>
</context>
<context>
    <name>isolux::ui::WindowLayout</name>
    <message>
        <source>&amp;Layout</source>
        <translation>&amp;Anordnung</translation>
    </message>
    <message>
        <source>&amp;Next layout</source>
        <translation>&amp;Nächste Anordnung</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Bedien&amp;felder</translation>
    </message>
    <message>
        <source>&amp;Float the front panel</source>
        <translation>Vorderes Bedienfeld &amp;lösen</translation>
    </message>
    <message>
        <source>&amp;Go to</source>
        <translation>&amp;Gehe zu</translation>
    </message>
    <message>
        <source>3-D &amp;view</source>
        <translation>3D-&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>&amp;Nächster Teil des Fensters</translation>
    </message>
    <message>
        <source>P&amp;revious part of the window</source>
        <translation>&amp;Voriger Teil des Fensters</translation>
    </message>
</context>
<context>
    <name>looks</name>
    <message>
        <source>crevice shading (accessibility): a light surface with dark hollows, like dirt</source>
        <translation>Vertiefungen: eine helle Oberfläche mit dunklen Vertiefungen, wie Schmutz</translation>
    </message>
    <message>
        <source>both principal curvatures: hue shows the kind of shape, grey is flat</source>
        <translation>beide Hauptkrümmungen: der Farbton zeigt die Art der Form, Grau ist flach</translation>
    </message>
    <message>
        <source>cool where the surface faces away from the light, warm where it faces the light</source>
        <translation>kalt, wo die Oberfläche vom Licht abgewandt ist, warm, wo sie ihm zugewandt ist</translation>
    </message>
    <message>
        <source>the distance from the surface to the edge of the object: positive is outside, grey has no edge</source>
        <translation>der Abstand von der Oberfläche zur Kante des Objekts: positiv ist außerhalb, Grau hat keine Kante</translation>
    </message>
    <message>
        <source>the strength of curvature, regardless of shape</source>
        <translation>die Stärke der Krümmung, gleich welcher Form</translation>
    </message>
    <message>
        <source>streaks along the principal curvature directions</source>
        <translation>Streifen längs der Hauptkrümmungsrichtungen</translation>
    </message>
    <message>
        <source>the distance from the viewer, in even steps of lightness</source>
        <translation>die Entfernung vom Betrachter, in gleichmäßigen Helligkeitsstufen</translation>
    </message>
    <message>
        <source>the kind of shape, regardless of size: -1 cup, 0 saddle, 1 cap</source>
        <translation>die Art der Form, gleich welcher Größe: -1 Mulde, 0 Sattel, 1 Kuppe</translation>
    </message>
    <message>
        <source>the larger principal curvature</source>
        <translation>die größere Hauptkrümmung</translation>
    </message>
    <message>
        <source>the mean of both principal curvatures</source>
        <translation>das Mittel beider Hauptkrümmungen</translation>
    </message>
    <message>
        <source>the outward normal as a colour, world axes</source>
        <translation>die äußere Normale als Farbe, Achsen des Raums</translation>
    </message>
    <message>
        <source>the product of both principal curvatures: positive on domes and in cups, negative on saddles</source>
        <translation>das Produkt beider Hauptkrümmungen: positiv auf Kuppen und in Mulden, negativ auf Sätteln</translation>
    </message>
    <message>
        <source>the smaller principal curvature</source>
        <translation>die kleinere Hauptkrümmung</translation>
    </message>
    <message>
        <source>the surface&apos;s own colour under baked global illumination</source>
        <translation>die eigene Farbe der Oberfläche in gespeicherter globaler Beleuchtung</translation>
    </message>
    <message>
        <source>the surface&apos;s own colour with a highlight</source>
        <translation>die eigene Farbe der Oberfläche mit Glanzlicht</translation>
    </message>
    <message>
        <source>the surface&apos;s own colour, matt</source>
        <translation>die eigene Farbe der Oberfläche, matt</translation>
    </message>
    <message>
        <source>the curvature of the gradient&apos;s flowlines: high where the isosurface is uncertain</source>
        <translation>die Krümmung der Flusslinien des Gradienten: groß, wo die Isofläche unsicher ist</translation>
    </message>
    <message>
        <source>the first principal direction as a colour: its parts along the world axes, without sign</source>
        <translation>die erste Hauptkrümmungsrichtung als Farbe: ihre Anteile entlang der Weltachsen, ohne Vorzeichen</translation>
    </message>
</context>
<context>
    <name>marks</name>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>piece</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>pin</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
</context>
<context>
    <name>passes</name>
    <message>
        <source>cached</source>
        <translation>zwischengespeichert</translation>
    </message>
    <message>
        <source>ran</source>
        <translation>berechnet</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>ausgelassen</translation>
    </message>
</context>
<context>
    <name>phantoms</name>
    <message>
        <source>CT-like head: skin, skull, teeth, brain, eyes, airways; a bead on the patient&apos;s left ear</source>
        <translation>CT-ähnlicher Kopf: Haut, Schädel, Zähne, Gehirn, Augen, Atemwege; eine Kugel am linken Ohr des Patienten</translation>
    </message>
    <message>
        <source>a sheet thinner than a voxel</source>
        <translation>ein Blatt, dünner als ein Voxel</translation>
    </message>
    <message>
        <source>half a ball, cut obliquely into parallel sheets and gaps, each two voxels thick</source>
        <translation>eine halbe Kugel, schräg in parallele Blätter und Lücken geschnitten, je zwei Voxel dick</translation>
    </message>
    <message>
        <source>height below a hyperbolic paraboloid</source>
        <translation>Höhe unter einem hyperbolischen Paraboloid</translation>
    </message>
    <message>
        <source>signed distance to a ball</source>
        <translation>vorzeichenbehafteter Abstand zu einer Kugel</translation>
    </message>
    <message>
        <source>signed distance to a tilted plane</source>
        <translation>vorzeichenbehafteter Abstand zu einer geneigten Ebene</translation>
    </message>
    <message>
        <source>signed distance to a torus around the z axis</source>
        <translation>vorzeichenbehafteter Abstand zu einem Torus um die z-Achse</translation>
    </message>
    <message>
        <source>signed distance to an infinite cylinder along z</source>
        <translation>vorzeichenbehafteter Abstand zu einem unendlichen Zylinder längs z</translation>
    </message>
    <message>
        <source>six interlocking rings of wire with a smooth profile 1.4 voxels wide</source>
        <translation>sechs verschlungene Drahtringe mit glattem Profil, 1,4 Voxel breit</translation>
    </message>
    <message>
        <source>smooth random field with white noise</source>
        <translation>glattes Zufallsfeld mit weißem Rauschen</translation>
    </message>
    <message>
        <source>the Marschner-Lobb test signal for reconstruction</source>
        <translation>das Marschner-Lobb-Testsignal für Rekonstruktion</translation>
    </message>
    <message>
        <source>the triply periodic gyroid, four periods per edge</source>
        <translation>der dreifach periodische Gyroid, vier Perioden je Kante</translation>
    </message>
    <message>
        <source>two balls that touch at one point, where the gradient vanishes</source>
        <translation>zwei Kugeln, die sich in einem Punkt berühren, wo der Gradient verschwindet</translation>
    </message>
</context>
<context>
    <name>presets</name>
    <message>
        <source>Isosurface of a computed field.</source>
        <translation>Isofläche eines berechneten Felds.</translation>
    </message>
    <message>
        <source>CT bone</source>
        <translation>CT Knochen</translation>
    </message>
    <message>
        <source>CT lung and airways</source>
        <translation>CT Lunge und Atemwege</translation>
    </message>
    <message>
        <source>CT skin</source>
        <translation>CT Haut</translation>
    </message>
    <message>
        <source>CT skin over bone</source>
        <translation>CT Haut über Knochen</translation>
    </message>
    <message>
        <source>CT teeth and metal</source>
        <translation>CT Zähne und Metall</translation>
    </message>
    <message>
        <source>CT vessels with contrast</source>
        <translation>CT Gefäße mit Kontrastmittel</translation>
    </message>
    <message>
        <source>Distance field</source>
        <translation>Abstandsfeld</translation>
    </message>
    <message>
        <source>Enamel and metal in a CT, inside a faint shell of bone.</source>
        <translation>Zahnschmelz und Metall in einem CT, in einer schwachen Hülle aus Knochen.</translation>
    </message>
    <message>
        <source>Lungs and airways in a CT: the boundary of the air inside the body.</source>
        <translation>Lunge und Atemwege in einem CT: die Grenze der Luft im Körper.</translation>
    </message>
    <message>
        <source>MR brain</source>
        <translation>MR Gehirn</translation>
    </message>
    <message>
        <source>MR skin</source>
        <translation>MR Haut</translation>
    </message>
    <message>
        <source>MR vessels</source>
        <translation>MR Gefäße</translation>
    </message>
    <message>
        <source>Microscopy</source>
        <translation>Mikroskopie</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Stained structures in a microscopy stack, green on black.</source>
        <translation>Gefärbte Strukturen eines Mikroskopstapels, grün auf schwarz.</translation>
    </message>
    <message>
        <source>Outer skin in a CT, without the air of the room.</source>
        <translation>Die äußere Haut in einem CT, ohne die Luft des Raums.</translation>
    </message>
    <message>
        <source>Outer skin in an MR scan.</source>
        <translation>Äußere Haut in einer MR-Aufnahme.</translation>
    </message>
    <message>
        <source>Skeleton in a CT, in ivory under soft light.</source>
        <translation>Das Skelett in einem CT, elfenbeinfarben in weichem Licht.</translation>
    </message>
    <message>
        <source>Surface of a mesh or distance field (distance 0), coloured by mean curvature.</source>
        <translation>Fläche eines Netzes oder Abstandsfelds (Abstand 0), gefärbt nach mittlerer Krümmung.</translation>
    </message>
    <message>
        <source>White matter in a T1 scan of a brain alone or of a whole head.</source>
        <translation>Weiße Substanz in einer T1-Aufnahme eines Gehirns allein oder eines ganzen Kopfes.</translation>
    </message>
    <message>
        <source>Contrast-filled vessels in a CT, with bone of the same density.</source>
        <translation>Mit Kontrastmittel gefüllte Gefäße in einem CT, mit Knochen gleicher Dichte.</translation>
    </message>
    <message>
        <source>Vessels in a time-of-flight MR angiogram.</source>
        <translation>Gefäße in einer Time-of-Flight-MR-Angiographie.</translation>
    </message>
    <message>
        <source>its values are not distances in mm</source>
        <translation>seine Werte sind keine Abstände in mm</translation>
    </message>
    <message>
        <source>no white matter of a T1 scan is found in it</source>
        <translation>darin findet sich keine weiße Substanz einer T1-Aufnahme</translation>
    </message>
    <message>
        <source>Bone through skin; the skin is transparent where it faces the viewer and dense edge-on.</source>
        <translation>Knochen durch Haut; die Haut ist zum Betrachter hin durchsichtig und von der Kante gesehen dicht.</translation>
    </message>
    <message>
        <source>it is a CT</source>
        <translation>es ist ein CT</translation>
    </message>
    <message>
        <source>it is a scan of a patient</source>
        <translation>es ist die Aufnahme eines Patienten</translation>
    </message>
    <message>
        <source>it is known to be of another kind than a simulation</source>
        <translation>es ist keine Simulation</translation>
    </message>
    <message>
        <source>it is known to be of another kind than microscopy</source>
        <translation>es ist keine Mikroskopie</translation>
    </message>
    <message>
        <source>it is no CT, or its values do not tell Hounsfield units</source>
        <translation>es ist kein CT, oder die Werte lassen keine Hounsfield-Einheiten erkennen</translation>
    </message>
    <message>
        <source>it is no scan of a patient</source>
        <translation>es ist keine Aufnahme eines Patienten</translation>
    </message>
</context>
<context>
    <name>qualities</name>
    <message>
        <source>2 × 2 rays per pixel, 100 light paths per texel</source>
        <translation>2 × 2 Strahlen je Pixel, 100 Lichtpfade je Texel</translation>
    </message>
    <message>
        <source>4 × 4 rays per pixel, 400 light paths per texel, exact hits</source>
        <translation>4 × 4 Strahlen je Pixel, 400 Lichtpfade je Texel, exakte Treffer</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>One ray per pixel, 16 light paths per texel</source>
        <translation>Ein Strahl je Pixel, 16 Lichtpfade je Texel</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
</context>
<context>
    <name>reasons</name>
    <message>
        <source>a constant environment has no bright areas</source>
        <translation>eine konstante Umgebung hat keine hellen Stellen</translation>
    </message>
    <message>
        <source>a constant environment looks the same in every rotation</source>
        <translation>eine konstante Umgebung sieht gedreht gleich aus</translation>
    </message>
    <message>
        <source>a constant environment can change without a new bake</source>
        <translation>eine konstante Umgebung kann sich ohne neue Berechnung ändern</translation>
    </message>
    <message>
        <source>this look shows no quantity in colour</source>
        <translation>diese Darstellung zeigt keine Größe in Farbe</translation>
    </message>
    <message>
        <source>the strength of contours is 0</source>
        <translation>die Stärke der Konturen ist 0</translation>
    </message>
    <message>
        <source>depth does not depend on the side</source>
        <translation>die Tiefe hängt nicht von der Seite ab</translation>
    </message>
    <message>
        <source>derivatives at a scale σ &gt; 0 read single voxels</source>
        <translation>Ableitungen mit einer Skala σ &gt; 0 lesen einzelne Voxel</translation>
    </message>
    <message>
        <source>every isosurface is opaque</source>
        <translation>alle Isoflächen sind deckend</translation>
    </message>
    <message>
        <source>gi.mode has direct light only</source>
        <translation>gi.mode hat nur direktes Licht</translation>
    </message>
    <message>
        <source>gi.mode sets what is baked</source>
        <translation>gi.mode bestimmt, was gespeichert wird</translation>
    </message>
    <message>
        <source>hits are exact</source>
        <translation>Treffer sind exakt</translation>
    </message>
    <message>
        <source>hits are sampled</source>
        <translation>Treffer sind abgetastet</translation>
    </message>
    <message>
        <source>hit.field is already a spline</source>
        <translation>hit.field ist schon ein Spline</translation>
    </message>
    <message>
        <source>each isosurface has its own colour</source>
        <translation>jede Isofläche hat ihre eigene Farbe</translation>
    </message>
    <message>
        <source>light is baked on the surface of hit.field</source>
        <translation>Licht ist auf der Fläche von hit.field gespeichert</translation>
    </message>
    <message>
        <source>no bounces are traced</source>
        <translation>es werden keine Reflexionen verfolgt</translation>
    </message>
    <message>
        <source>no clip box is set</source>
        <translation>kein Schnittquader ist gesetzt</translation>
    </message>
    <message>
        <source>no flow is drawn: the look is not flow and flow.strength is 0</source>
        <translation>es wird keine Strömung gezeichnet: die Darstellung ist nicht Strömung, und flow.strength ist 0</translation>
    </message>
    <message>
        <source>no irradiance is baked</source>
        <translation>es wird keine Bestrahlungsstärke gespeichert</translation>
    </message>
    <message>
        <source>no isolines are drawn</source>
        <translation>es werden keine Isolinien gezeichnet</translation>
    </message>
    <message>
        <source>connected components are shown everywhere</source>
        <translation>Teile werden überall gezeigt</translation>
    </message>
    <message>
        <source>no isosurface is shown</source>
        <translation>keine Isofläche wird gezeigt</translation>
    </message>
    <message>
        <source>no legend is drawn</source>
        <translation>es wird keine Legende gezeichnet</translation>
    </message>
    <message>
        <source>no light is baked</source>
        <translation>es wird kein Licht gespeichert</translation>
    </message>
    <message>
        <source>no second volume is combined with the first</source>
        <translation>kein zweites Volumen ist mit dem ersten verknüpft</translation>
    </message>
    <message>
        <source>no transfer is baked</source>
        <translation>es wird kein Transfer gespeichert</translation>
    </message>
    <message>
        <source>no clip plane or clip box is set</source>
        <translation>weder Schnittebene noch Schnittquader ist gesetzt</translation>
    </message>
    <message>
        <source>the second volume is not visible</source>
        <translation>das zweite Volumen ist nicht zu sehen</translation>
    </message>
    <message>
        <source>only Blinn-Phong shading has a highlight</source>
        <translation>nur Blinn-Phong-Schattierung hat ein Glanzlicht</translation>
    </message>
    <message>
        <source>only local shading uses this light</source>
        <translation>nur lokale Schattierung verwendet dieses Licht</translation>
    </message>
    <message>
        <source>paths end before that bounce</source>
        <translation>Pfade enden vor dieser Reflexion</translation>
    </message>
    <message>
        <source>the strength of ridge and valley lines is 0</source>
        <translation>die Stärke der Grat- und Tallinien ist 0</translation>
    </message>
    <message>
        <source>the slab thickness is 0</source>
        <translation>die Dicke der Schichten ist 0</translation>
    </message>
    <message>
        <source>texels are not chosen by isovalue</source>
        <translation>Texel werden nicht nach dem Isowert gewählt</translation>
    </message>
    <message>
        <source>that isosurface is not shown</source>
        <translation>diese Isofläche wird nicht gezeigt</translation>
    </message>
    <message>
        <source>that light source is off</source>
        <translation>diese Lichtquelle ist aus</translation>
    </message>
    <message>
        <source>the albedo comes from a colour map</source>
        <translation>die Albedo kommt aus einer Farbskala</translation>
    </message>
    <message>
        <source>the exposure is set</source>
        <translation>die Belichtung ist gesetzt</translation>
    </message>
    <message>
        <source>the strength of the highlight is 0</source>
        <translation>die Stärke des Glanzlichts ist 0</translation>
    </message>
    <message>
        <source>the key light has no effect</source>
        <translation>das Hauptlicht hat keine Wirkung</translation>
    </message>
    <message>
        <source>the key light is the only light</source>
        <translation>das Hauptlicht ist das einzige Licht</translation>
    </message>
    <message>
        <source>occlusion is off</source>
        <translation>Verdeckung ist aus</translation>
    </message>
    <message>
        <source>the light source has a position</source>
        <translation>die Lichtquelle hat eine Position</translation>
    </message>
    <message>
        <source>the light source is distant</source>
        <translation>die Lichtquelle ist fern</translation>
    </message>
    <message>
        <source>the light source is not a sphere</source>
        <translation>die Lichtquelle ist keine Kugel</translation>
    </message>
    <message>
        <source>the light source is not distant</source>
        <translation>die Lichtquelle ist nicht fern</translation>
    </message>
    <message>
        <source>the look is not curvature 2D</source>
        <translation>die Darstellung ist nicht κ₁ und κ₂</translation>
    </message>
    <message>
        <source>the look shows crevice shading at full strength</source>
        <translation>die Darstellung zeigt Vertiefungen in voller Stärke</translation>
    </message>
    <message>
        <source>the look shows flow at full strength</source>
        <translation>die Darstellung zeigt Strömung in voller Stärke</translation>
    </message>
    <message>
        <source>hit.near_factor is 1</source>
        <translation>hit.near_factor ist 1</translation>
    </message>
    <message>
        <source>the strength of the second volume&apos;s colours is 0</source>
        <translation>die Stärke der Farben des zweiten Volumens ist 0</translation>
    </message>
    <message>
        <source>the shading is not global illumination</source>
        <translation>die Schattierung ist nicht globale Beleuchtung</translation>
    </message>
    <message>
        <source>the shading is not tone</source>
        <translation>die Schattierung ist nicht Warm-Kalt</translation>
    </message>
    <message>
        <source>the source is not a triangle mesh</source>
        <translation>die Quelle ist kein Dreiecksnetz</translation>
    </message>
    <message>
        <source>no uncertainty surfaces are drawn</source>
        <translation>es werden keine Unsicherheitsflächen gezeichnet</translation>
    </message>
    <message>
        <source>an environment map is set</source>
        <translation>ein Umgebungsbild ist gesetzt</translation>
    </message>
    <message>
        <source>a constant environment is set</source>
        <translation>eine konstante Umgebung ist gesetzt</translation>
    </message>
    <message>
        <source>there is no fog</source>
        <translation>es gibt keinen Nebel</translation>
    </message>
    <message>
        <source>there is no second volume</source>
        <translation>es gibt kein zweites Volumen</translation>
    </message>
    <message>
        <source>there is no texture</source>
        <translation>es gibt keine Textur</translation>
    </message>
    <message>
        <source>this look does not show a single quantity in colour</source>
        <translation>diese Darstellung zeigt keine einzelne Größe in Farbe</translation>
    </message>
    <message>
        <source>this look does not show the surface&apos;s own colour</source>
        <translation>diese Darstellung zeigt die eigene Farbe der Oberfläche nicht</translation>
    </message>
    <message>
        <source>this look is a shading itself, or shows a raw quantity</source>
        <translation>diese Darstellung ist selbst eine Schattierung oder zeigt eine rohe Größe</translation>
    </message>
    <message>
        <source>this look needs no curvature</source>
        <translation>diese Darstellung braucht keine Krümmung</translation>
    </message>
    <message>
        <source>this look needs no derivatives</source>
        <translation>diese Darstellung braucht keine Ableitungen</translation>
    </message>
    <message>
        <source>this look shows a raw quantity without overlays</source>
        <translation>diese Darstellung zeigt eine rohe Größe ohne Überlagerungen</translation>
    </message>
    <message>
        <source>this look shows no edges</source>
        <translation>diese Darstellung zeigt keine Kanten</translation>
    </message>
    <message>
        <source>this shading ignores the brightness of the key light</source>
        <translation>diese Schattierung beachtet die Helligkeit des Hauptlichts nicht</translation>
    </message>
    <message>
        <source>this setting affects cubic derivatives only</source>
        <translation>diese Einstellung betrifft nur kubische Ableitungen</translation>
    </message>
    <message>
        <source>trilinear derivatives have no scale</source>
        <translation>trilineare Ableitungen haben keine Skala</translation>
    </message>
    <message>
        <source>no lines or streaks sized in pixels are drawn</source>
        <translation>es werden keine Linien oder Streifen mit Größe in Pixeln gezeichnet</translation>
    </message>
    <message>
        <source>the opacity of the surface is 0</source>
        <translation>die Deckkraft der Fläche ist 0</translation>
    </message>
    <message>
        <source>camera.eye is set</source>
        <translation>camera.eye ist gesetzt</translation>
    </message>
    <message>
        <source>the isovalue is set</source>
        <translation>der Isowert ist gesetzt</translation>
    </message>
    <message>
        <source>colours show numbers</source>
        <translation>die Farben zeigen Zahlen</translation>
    </message>
    <message>
        <source>control points are set (look.colormap_points)</source>
        <translation>Kontrollpunkte sind gesetzt (look.colormap_points)</translation>
    </message>
    <message>
        <source>crevice shading is off</source>
        <translation>die Vertiefungsschattierung ist aus</translation>
    </message>
    <message>
        <source>source.csg is not blend</source>
        <translation>source.csg ist nicht blend</translation>
    </message>
    <message>
        <source>the surface is matt</source>
        <translation>die Fläche ist matt</translation>
    </message>
    <message>
        <source>several isosurfaces are lit</source>
        <translation>mehrere Isoflächen sind beleuchtet</translation>
    </message>
    <message>
        <source>the data are no labels</source>
        <translation>die Daten sind keine Labels</translation>
    </message>
    <message>
        <source>there is no such item</source>
        <translation>es gibt keinen solchen Eintrag</translation>
    </message>
    <message>
        <source>source.labels draws the values of the labels</source>
        <translation>source.labels zeichnet die Werte der Labels</translation>
    </message>
    <message>
        <source>that surface is not shown</source>
        <translation>diese Fläche wird nicht gezeigt</translation>
    </message>
</context>
<context>
    <name>sentences</name>
    <message>
        <source>No surface: the volume has only one voxel along an axis</source>
        <translation>Keine Oberfläche: Das Volumen hat längs einer Achse nur ein Voxel</translation>
    </message>
    <message>
        <source>No surface: all voxels are missing</source>
        <translation>Keine Oberfläche: Alle Voxel fehlen</translation>
    </message>
    <message>
        <source>No surface at %1: the data range is %2 to %3</source>
        <translation>Keine Oberfläche bei %1: Der Wertebereich ist %2 bis %3</translation>
    </message>
    <message>
        <source>The camera looks away from the volume</source>
        <translation>Die Kamera blickt vom Volumen weg</translation>
    </message>
    <message>
        <source>The volume is outside the image</source>
        <translation>Das Volumen ist außerhalb des Bildes</translation>
    </message>
    <message>
        <source>No surface is visible from here</source>
        <translation>Von hier ist keine Oberfläche zu sehen</translation>
    </message>
    <message>
        <source>Every isosurface is fully transparent</source>
        <translation>Alle Isoflächen sind völlig durchsichtig</translation>
    </message>
    <message>
        <source>The isosurface is fully transparent</source>
        <translation>Die Isofläche ist völlig durchsichtig</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>vor %1 s</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>vor %1 min</translation>
    </message>
    <message>
        <source>%1 h ago</source>
        <translation>vor %1 h</translation>
    </message>
    <message>
        <source>%1 days ago</source>
        <translation>vor %1 Tagen</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>straight %1 %2</source>
        <translation>gerade %1 %2</translation>
    </message>
    <message>
        <source>along surface</source>
        <translation>entlang der Oberfläche</translation>
    </message>
    <message>
        <source>along surface %1 %2</source>
        <translation>entlang der Oberfläche %1 %2</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>centre %1</source>
        <translation>Mittelpunkt %1</translation>
    </message>
    <message>
        <source>ray</source>
        <translation>Strahl</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>piece</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>surface distance</source>
        <translation>Abstand zur Oberfläche</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>edge offset</source>
        <translation>Kantenversatz</translation>
    </message>
    <message>
        <source>edge strength</source>
        <translation>Kantenstärke</translation>
    </message>
    <message>
        <source>the point is not on the surface: no surface within three voxels</source>
        <translation>der Punkt ist nicht auf der Oberfläche: keine Oberfläche im Umkreis von drei Voxeln</translation>
    </message>
    <message>
        <source>point %1 is not on the surface: no surface within three voxels</source>
        <translation>Punkt %1 ist nicht auf der Oberfläche: keine Oberfläche im Umkreis von drei Voxeln</translation>
    </message>
    <message>
        <source>the point is %1 mm off the surface</source>
        <translation>der Punkt ist %1 mm von der Oberfläche entfernt</translation>
    </message>
    <message>
        <source>point %1 is %2 mm off the surface</source>
        <translation>Punkt %1 ist %2 mm von der Oberfläche entfernt</translation>
    </message>
    <message>
        <source>no isosurface of %1 within three voxels of the point</source>
        <translation>keine Isofläche von %1 im Umkreis von drei Voxeln um den Punkt</translation>
    </message>
    <message>
        <source>no isosurface of %1 within three voxels of point %2</source>
        <translation>keine Isofläche von %1 im Umkreis von drei Voxeln um Punkt %2</translation>
    </message>
    <message>
        <source>the point is outside the volume or next to missing voxels</source>
        <translation>der Punkt ist außerhalb des Volumens oder neben fehlenden Voxeln</translation>
    </message>
    <message>
        <source>no path along the surface from point %1 to point %2</source>
        <translation>kein Weg entlang der Oberfläche von Punkt %1 zu Punkt %2</translation>
    </message>
    <message>
        <source>two of the points coincide</source>
        <translation>zwei der Punkte fallen zusammen</translation>
    </message>
    <message>
        <source>the points are on a line</source>
        <translation>die Punkte sind auf einer Geraden</translation>
    </message>
    <message>
        <source>the inside behind the point extends beyond the data</source>
        <translation>das Innere hinter dem Punkt reicht über die Daten hinaus</translation>
    </message>
    <message>
        <source>the point is in no connected component at isovalue %1</source>
        <translation>der Punkt ist in keinem Teil zum Isowert %1</translation>
    </message>
    <message>
        <source>the component is open: it extends beyond the data</source>
        <translation>das Teil ist offen: Es reicht über die Daten hinaus</translation>
    </message>
    <message>
        <source>not enough memory</source>
        <translation>zu wenig Speicher</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>no settings keep %1 ms; the fastest take about %2 ms; choose a smaller image</source>
        <translation>keine Einstellungen halten %1 ms ein; die schnellsten brauchen etwa %2 ms; ein kleineres Bild wählen</translation>
    </message>
    <message>
        <source>no settings keep %1; the smallest guaranteed error is %2</source>
        <translation>keine Einstellungen halten ein: %1; der kleinste zugesicherte Fehler ist %2</translation>
    </message>
    <message>
        <source>depth at most %1 mm</source>
        <translation>Tiefe höchstens %1 mm</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>Tiefe %1 mm</translation>
    </message>
    <message>
        <source>depth at most %1 voxels</source>
        <translation>Tiefe höchstens %1 Voxel</translation>
    </message>
    <message>
        <source>depth %1 voxels</source>
        <translation>Tiefe %1 Voxel</translation>
    </message>
    <message>
        <source>missed at most %1 %</source>
        <translation>verfehlt höchstens %1 %</translation>
    </message>
    <message>
        <source>missed %1 %</source>
        <translation>verfehlt %1 %</translation>
    </message>
    <message>
        <source>normal at most %1 degrees</source>
        <translation>Normale höchstens %1 Grad</translation>
    </message>
    <message>
        <source>normal %1 degrees</source>
        <translation>Normale %1 Grad</translation>
    </message>
    <message>
        <source>curvature at most %1 %</source>
        <translation>Krümmung höchstens %1 %</translation>
    </message>
    <message>
        <source>curvature %1 %</source>
        <translation>Krümmung %1 %</translation>
    </message>
    <message>
        <source>light at most %1 %</source>
        <translation>Licht höchstens %1 %</translation>
    </message>
    <message>
        <source>light %1 %</source>
        <translation>Licht %1 %</translation>
    </message>
    <message>
        <source>%1 of %2 pieces hidden</source>
        <translation>%1 von %2 Teilen verborgen</translation>
    </message>
    <message>
        <source>%1 gap interpolated</source>
        <translation>%1 Lücke interpoliert</translation>
    </message>
    <message>
        <source>%1 gaps interpolated</source>
        <translation>%1 Lücken interpoliert</translation>
    </message>
    <message>
        <source>uneven slices resampled</source>
        <translation>ungleiche Schichten umgerechnet</translation>
    </message>
    <message>
        <source>parts missing</source>
        <translation>Teile fehlen</translation>
    </message>
    <message>
        <source>no settings keep %1; the smallest guaranteed error is %2; a larger image, gi.samples above 1024 or gi.lattice_scale above 2 may keep it</source>
        <translation>keine Einstellungen halten ein: %1; der kleinste zugesicherte Fehler ist %2; ein größeres Bild, gi.samples über 1024 oder gi.lattice_scale über 2 mag es einhalten</translation>
    </message>
    <message>
        <source>source.kind is set</source>
        <translation>source.kind ist gesetzt</translation>
    </message>
    <message>
        <source>its values are few whole numbers that fill regions</source>
        <translation>die Werte sind wenige ganze Zahlen, die Bereiche füllen</translation>
    </message>
    <message>
        <source>its header lists segments</source>
        <translation>der Kopf zählt Segmente auf</translation>
    </message>
    <message>
        <source>its header has a table of labels</source>
        <translation>der Kopf hat eine Tabelle von Labels</translation>
    </message>
    <message>
        <source>its metadata say image-label</source>
        <translation>die Metadaten sagen image-label</translation>
    </message>
    <message>
        <source>its intent_code is %1, labels</source>
        <translation>der intent_code ist %1, Labels</translation>
    </message>
    <message>
        <source>it is a DICOM segmentation</source>
        <translation>es ist eine DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>its name ends in %1</source>
        <translation>der Name endet auf %1</translation>
    </message>
    <message>
        <source>its name is that of FreeSurfer&apos;s labels</source>
        <translation>der Name ist der von FreeSurfers Labels</translation>
    </message>
    <message>
        <source>%1 beside it names labels</source>
        <translation>%1 daneben benennt Labels</translation>
    </message>
    <message>
        <source>%1 names labels</source>
        <translation>%1 benennt Labels</translation>
    </message>
    <message>
        <source>its file states it</source>
        <translation>die Datei gibt es an</translation>
    </message>
    <message>
        <source>it was made from a mesh</source>
        <translation>aus einem Netz erzeugt</translation>
    </message>
    <message>
        <source>its values are in mm</source>
        <translation>die Werte sind in mm</translation>
    </message>
    <message>
        <source>its values are in %1</source>
        <translation>die Werte sind in %1</translation>
    </message>
    <message>
        <source>its data range is that of a CT</source>
        <translation>der Wertebereich ist der eines CT</translation>
    </message>
    <message>
        <source>most of its voxels have the value of soft tissue, as in a CT</source>
        <translation>die meisten Voxel haben den Wert von Weichteilen, wie in einem CT</translation>
    </message>
    <message>
        <source>it is a scan of a patient, and its values are not those of a CT</source>
        <translation>die Aufnahme eines Patienten, deren Werte nicht die eines CT sind</translation>
    </message>
    <message>
        <source>its voxels are smaller than 2 micrometres</source>
        <translation>die Voxel sind kleiner als 2 Mikrometer</translation>
    </message>
    <message>
        <source>its values have no noise</source>
        <translation>die Werte sind ohne Rauschen</translation>
    </message>
    <message>
        <source>there is no other evidence</source>
        <translation>es gibt keine weiteren Hinweise</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>Second volume whose values colour the surface, given as in source.path; if empty, none is used.</source>
        <translation>Zweites Volumen, dessen Werte die Oberfläche färben, angegeben wie source.path; ist es leer, wird keines verwendet.</translation>
    </message>
    <message>
        <source>Solid (3-D) texture that varies the albedo.</source>
        <translation>Festkörpertextur (3-D), die die Albedo variiert.</translation>
    </message>
    <message>
        <source>Direction of the streaks: of the larger or the smaller principal curvature.</source>
        <translation>Richtung der Streifen: die der größeren oder der kleineren Hauptkrümmung.</translation>
    </message>
    <message>
        <source>Supersampling (anti-aliasing) of final images.</source>
        <translation>Kantenglättung fertiger Bilder.</translation>
    </message>
    <message>
        <source>Background at the bottom of the image.</source>
        <translation>Hintergrund am unteren Rand des Bildes.</translation>
    </message>
    <message>
        <source>Background at the top of the image.</source>
        <translation>Hintergrund am oberen Rand des Bildes.</translation>
    </message>
    <message>
        <source>Number of spherical harmonic bands of baked transfer; more bands resolve sharper light.</source>
        <translation>Anzahl der Bänder der Kugelflächenfunktionen des gespeicherten Transfers; mehr Bänder lösen schärferes Licht auf.</translation>
    </message>
    <message>
        <source>Brightness of a white light at the eye.</source>
        <translation>Helligkeit eines weißen Lichts am Auge.</translation>
    </message>
    <message>
        <source>Brightness of the fill light, on the viewer&apos;s other side, as a fraction of the key light&apos;s.</source>
        <translation>Helligkeit des Aufhelllichts, auf der anderen Seite des Betrachters, als Anteil der des Hauptlichts.</translation>
    </message>
    <message>
        <source>Brightness of the two rim lights, behind left and right, as a fraction of the key light&apos;s.</source>
        <translation>Helligkeit der zwei Kantenlichter, hinten links und rechts, als Anteil der des Hauptlichts.</translation>
    </message>
    <message>
        <source>Lighting: three_point has a key light, a fill light and rim lights, each occluded by nearby surfaces; key has the key light alone.</source>
        <translation>Beleuchtung: three_point hat Haupt-, Aufhell- und Kantenlichter, jeweils von nahen Flächen verdeckt; key hat das Hauptlicht allein.</translation>
    </message>
    <message>
        <source>Strength of screen-space occlusion: nearby surfaces visible in the image darken crevices.</source>
        <translation>Stärke der Verdeckung im Bildraum: nahe Flächen, die das Bild zeigt, verdunkeln Spalten.</translation>
    </message>
    <message>
        <source>Radius within which surfaces occlude; auto is a fifth of the volume&apos;s diagonal.</source>
        <translation>Radius, in dem Flächen verdecken; auto ist ein Fünftel der Diagonale des Volumens.</translation>
    </message>
    <message>
        <source>Brightness of a white surface that faces the light source at the volume&apos;s centre.</source>
        <translation>Helligkeit einer weißen Fläche in der Mitte des Volumens, die der Lichtquelle zugewandt ist.</translation>
    </message>
    <message>
        <source>Exposure of images lit by global illumination; auto follows picture.metering.</source>
        <translation>Belichtung von Bildern mit globaler Beleuchtung; auto richtet sich nach picture.metering.</translation>
    </message>
    <message>
        <source>Brightness of the key light.</source>
        <translation>Helligkeit des Hauptlichts.</translation>
    </message>
    <message>
        <source>Colour of contour lines.</source>
        <translation>Farbe der Konturlinien.</translation>
    </message>
    <message>
        <source>Colour of ridges.</source>
        <translation>Farbe der Grate.</translation>
    </message>
    <message>
        <source>Colour of the light source.</source>
        <translation>Farbe der Lichtquelle.</translation>
    </message>
    <message>
        <source>Colour of the key light.</source>
        <translation>Farbe des Hauptlichts.</translation>
    </message>
    <message>
        <source>Colour of valleys.</source>
        <translation>Farbe der Täler.</translation>
    </message>
    <message>
        <source>Colour map of the quantity; auto is diverging for signed quantities, otherwise viridis.</source>
        <translation>Farbskala der Größe; auto ist divergierend für Größen mit Vorzeichen, sonst Viridis.</translation>
    </message>
    <message>
        <source>Minimum curvature of ridge and valley lines; auto derives it from the values on the surface.</source>
        <translation>Mindestkrümmung der Grat- und Tallinien; auto folgt aus den Werten auf der Oberfläche.</translation>
    </message>
    <message>
        <source>Damping of the environment&apos;s high bands against ringing.</source>
        <translation>Dämpfung der hohen Bänder der Umgebung gegen Überschwingen.</translation>
    </message>
    <message>
        <source>Crevice shading (accessibility, Miller 1994): darkens hollows by curvature, like dirt.</source>
        <translation>Vertiefungen (accessibility, Miller 1994): verdunkelt sie nach der Krümmung, wie Schmutz.</translation>
    </message>
    <message>
        <source>Angular diameter of a distant light; the sun has 0.53, 0 gives hard shadows.</source>
        <translation>Winkeldurchmesser eines fernen Lichts; die Sonne hat 0,53, 0 gibt harte Schatten.</translation>
    </message>
    <message>
        <source>Maximum number of diffuse reflections of a light path; 0 is direct light only.</source>
        <translation>Höchstzahl diffuser Reflexionen eines Lichtpfads; 0 ist nur direktes Licht.</translation>
    </message>
    <message>
        <source>Draws a legend with units where colours show a quantity.</source>
        <translation>Zeichnet eine Legende mit Einheiten, wo Farben eine Größe zeigen.</translation>
    </message>
    <message>
        <source>Specular exponent; higher values give a smaller, sharper highlight.</source>
        <translation>Exponent des Glanzlichts; höhere Werte geben ein kleineres, schärferes Glanzlicht.</translation>
    </message>
    <message>
        <source>Fills the uncertainty band of the first surface&apos;s contour: its isovalue ± this many standard deviations of the noise; 0 fills nothing.</source>
        <translation>Füllt das Unsicherheitsband der Kontur der ersten Fläche: ihr Isowert ± so vielen Standardabweichungen des Rauschens; 0 füllt nichts.</translation>
    </message>
    <message>
        <source>Bounce at which Russian roulette begins: paths then end at random, with the probability that light is absorbed.</source>
        <translation>Reflexion, an der russisches Roulette beginnt: Pfade enden dann zufällig, mit der Wahrscheinlichkeit, dass Licht absorbiert wird.</translation>
    </message>
    <message>
        <source>Graphics memory for voxels, baked light and images.</source>
        <translation>Grafikspeicher für Voxel, gespeichertes Licht und Bilder.</translation>
    </message>
    <message>
        <source>Memory for bricks of an out-of-core volume.</source>
        <translation>Arbeitsspeicher für Blöcke eines Volumens, das in seiner Datei bleibt.</translation>
    </message>
    <message>
        <source>Location of the voxels while drawing: memory, or the file, which is read in parts when needed (out of core). auto uses the file if the volume does not fit in memory.</source>
        <translation>Ort der Voxel beim Zeichnen: der Arbeitsspeicher oder die Datei, von der Teile nach Bedarf gelesen werden. auto nimmt die Datei, wenn das Volumen nicht in den Arbeitsspeicher passt.</translation>
    </message>
    <message>
        <source>Boolean operation that combines a second volume with the first, as solids on one grid.</source>
        <translation>Boolesche Operation, die ein zweites Volumen mit dem ersten verknüpft, als Körper auf einem Gitter.</translation>
    </message>
    <message>
        <source>Voxel access of cubic derivatives: the texture unit&apos;s linear filter, whose weights many GPUs round to 8 bits, or single voxels weighted in float.</source>
        <translation>Voxelzugriff kubischer Ableitungen: der lineare Filter der Textureinheit, dessen Gewichte viele GPUs auf 8 Bit runden, oder einzelne Voxel mit Gleitkommagewichten.</translation>
    </message>
    <message>
        <source>Sampling rate along a ray; method sampled only.</source>
        <translation>Abtastrate längs eines Strahls; nur bei Verfahren Abgetastet.</translation>
    </message>
    <message>
        <source>Search distance for the edge of the object along the normal, in both directions; auto depends on spacing and scale.</source>
        <translation>Suchstrecke für die Kante des Objekts längs der Normalen, in beide Richtungen; auto hängt von Voxelabstand und Skala ab.</translation>
    </message>
    <message>
        <source>Minimum gradient magnitude of an edge, in standard deviations of the gradient&apos;s noise; weaker maxima are ignored.</source>
        <translation>Mindestbetrag des Gradienten einer Kante, in Standardabweichungen des Gradientenrauschens; schwächere Maxima bleiben außer Acht.</translation>
    </message>
    <message>
        <source>Window width: the range of values from black to white in slices and on caps; auto derives it from the volume.</source>
        <translation>Fensterbreite: der Wertebereich von Schwarz bis Weiß in Schichten und auf Schnittflächen; auto folgt aus dem Volumen.</translation>
    </message>
    <message>
        <source>Resolution of the distance field made from a triangle mesh: voxels along the longest axis.</source>
        <translation>Auflösung des Abstandsfelds eines Dreiecksnetzes: Voxel entlang der längsten Achse.</translation>
    </message>
    <message>
        <source>Resolution of the lattice of baked light.</source>
        <translation>Auflösung des gespeicherten Lichts.</translation>
    </message>
    <message>
        <source>Time limit of an interactive frame.</source>
        <translation>Zeitgrenze eines Bildes bei Bewegung.</translation>
    </message>
    <message>
        <source>Maximum number of connected components (pieces) shown per isosurface, largest first; 0 shows all.</source>
        <translation>Höchstzahl der gezeigten zusammenhängenden Teile je Isofläche, das größte zuerst; 0 zeigt alle.</translation>
    </message>
    <message>
        <source>Maximum number of surface crossings composited along a ray, where surfaces are transparent.</source>
        <translation>Höchstzahl der Durchtritte, die längs eines Strahls überlagert werden, wo Flächen durchsichtig sind.</translation>
    </message>
    <message>
        <source>Factor by which sampling is denser near the isovalue; method sampled only.</source>
        <translation>Faktor, um den die Abtastung nahe dem Isowert dichter ist; nur bei Verfahren Abgetastet.</translation>
    </message>
    <message>
        <source>Hemisphere lighting: how much brighter the ambient light is from the top of the image than from the bottom.</source>
        <translation>Himmelslicht: wie viel heller das Umgebungslicht vom oberen Bildrand ist als vom unteren.</translation>
    </message>
    <message>
        <source>Opacity of these colours over the surface&apos;s own colour.</source>
        <translation>Deckkraft dieser Farben über der eigenen Farbe der Oberfläche.</translation>
    </message>
    <message>
        <source>Opacity of the surface; 1 hides everything behind it.</source>
        <translation>Deckkraft der Fläche; 1 verdeckt alles hinter ihr.</translation>
    </message>
    <message>
        <source>Opacity of the uncertainty surfaces.</source>
        <translation>Deckkraft der Unsicherheitsflächen.</translation>
    </message>
    <message>
        <source>Amount by which the far end of the volume fades.</source>
        <translation>Stärke, mit der das ferne Ende des Volumens verblasst.</translation>
    </message>
    <message>
        <source>Speed of the animation: periods of the pattern per second.</source>
        <translation>Geschwindigkeit der Animation: Perioden des Musters je Sekunde.</translation>
    </message>
    <message>
        <source>Intersection of rays with the surface: equidistant samples with refinement, or the first root of the interpolant in each cell.</source>
        <translation>Schnitt von Strahlen mit der Fläche: gleichabständige Abtastung mit Verfeinerung oder die erste Nullstelle des Interpolanten in der Zelle.</translation>
    </message>
    <message>
        <source>Interpolation of baked light between texels; weighted favours texels whose normal fits, and smooths noise along their isosurfaces.</source>
        <translation>Interpolation des gespeicherten Lichts zwischen Texeln; gewichtet bevorzugt Texel mit passender Normale und glättet das Rauschen längs ihrer Isoflächen.</translation>
    </message>
    <message>
        <source>Rotation of the clip box about its centre.</source>
        <translation>Drehung des Schnittquaders um seine Mitte.</translation>
    </message>
    <message>
        <source>Slab thickness of slices, half in front of and half behind their plane; 0 shows the plane itself.</source>
        <translation>Dicke der Schichten, zur Hälfte vor und hinter ihrer Ebene; 0 zeigt die Ebene selbst.</translation>
    </message>
    <message>
        <source>Layout of a file without a header: &quot;WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]&quot;.</source>
        <translation>Aufbau einer Datei ohne Kopf: „BxHxT TYP [little|big] [spacing x,y,z] [header BYTES]“.</translation>
    </message>
    <message>
        <source>Minimum depth inside that body for half of a component, as a fraction of the body&apos;s greatest depth. A brain is deep enough; its scalp is not.</source>
        <translation>Mindesttiefe der Hälfte eines Teils in diesem Körper, als Anteil der größten Tiefe des Körpers. Ein Gehirn liegt tief genug, seine Kopfhaut nicht.</translation>
    </message>
    <message>
        <source>Layout of the second volume&apos;s file without a header, as source.raw.</source>
        <translation>Aufbau der Datei des zweiten Volumens ohne Kopf, wie source.raw.</translation>
    </message>
    <message>
        <source>Length of a streak.</source>
        <translation>Länge eines Streifens.</translation>
    </message>
    <message>
        <source>Animates the streaks in the window.</source>
        <translation>Bewegt die Streifen im Fenster.</translation>
    </message>
    <message>
        <source>Fades the strength in, from 0 at the lower end of the map to its full value at the upper end.</source>
        <translation>Blendet die Stärke ein, von 0 am unteren Ende der Skala bis zum vollen Wert am oberen Ende.</translation>
    </message>
    <message>
        <source>Ambient light, as a fraction of the albedo.</source>
        <translation>Umgebungslicht, als Anteil der Albedo.</translation>
    </message>
    <message>
        <source>Interval between isolines of the second volume; 0 draws none.</source>
        <translation>Abstand der Isolinien des zweiten Volumens; 0 zeichnet keine.</translation>
    </message>
    <message>
        <source>Control points [kappa1, kappa2, r, g, b] of the colour map of curvature_2d; kappa1 and kappa2 are fractions of the range. auto: hue from the shape index, chroma from the curvedness.</source>
        <translation>Stützpunkte [kappa1, kappa2, r, g, b] der Farbskala von curvature_2d; kappa1 und kappa2 sind Anteile des Bereichs. auto: Farbton nach dem Formindex, Buntheit nach der Stärke der Krümmung.</translation>
    </message>
    <message>
        <source>Light paths per texel; four times as many halve the noise.</source>
        <translation>Lichtpfade je Texel; viermal so viele halbieren das Rauschen.</translation>
    </message>
    <message>
        <source>Exposure of the environment: multiplies its radiance by 2 to this power.</source>
        <translation>Belichtung der Umgebung: multipliziert ihre Strahldichte mit 2 hoch diesem Wert.</translation>
    </message>
    <message>
        <source>Back-face tint: multiplies the surface&apos;s own colour where its back face is visible; white does not tint.</source>
        <translation>Tönung der Rückseite: multipliziert die eigene Farbe der Oberfläche, wo ihre Rückseite zu sehen ist; Weiß tönt nicht.</translation>
    </message>
    <message>
        <source>Number format of irradiance on the GPU: 4 or 8 bytes per texel.</source>
        <translation>Zahlenformat der Bestrahlungsstärke auf der Grafikkarte: 4 oder 8 Byte je Texel.</translation>
    </message>
    <message>
        <source>Radius of a sphere light; a larger one gives softer shadows; auto is a tenth of the volume&apos;s diagonal.</source>
        <translation>Radius eines Kugellichts; größer gibt weichere Schatten; auto ist ein Zehntel der Diagonale des Volumens.</translation>
    </message>
    <message>
        <source>Mean number of bits per principal component; components that vary more get more. The bits of a texel are rounded up to a multiple of 32.</source>
        <translation>Mittlere Zahl der Bits je Hauptkomponente; Komponenten, die mehr schwanken, bekommen mehr. Die Bits eines Texels werden auf ein Vielfaches von 32 aufgerundet.</translation>
    </message>
    <message>
        <source>Draws interactive frames at a lower resolution until they are fast enough; the full image follows when the view is idle.</source>
        <translation>Zeichnet Bilder bei Bewegung in geringerer Auflösung, bis sie schnell genug sind; in Ruhe folgt das volle Bild.</translation>
    </message>
    <message>
        <source>Shows only connected components with at least half inside the body above this value, for example the skin&apos;s. This hides a headrest or a table. Structures thinner than 8 mm do not count as body; auto shows components everywhere.</source>
        <translation>Zeigt nur zusammenhängende Teile, die mindestens zur Hälfte im Körper über diesem Wert liegen, etwa dem der Haut. Kopfstütze und Liege sind dann verborgen. Strukturen dünner als 8 mm gelten nicht als Körper; auto zeigt Teile überall.</translation>
    </message>
    <message>
        <source>Hides connected components that enclose a smaller volume.</source>
        <translation>Verbirgt zusammenhängende Teile, die ein kleineres Volumen umschließen.</translation>
    </message>
    <message>
        <source>Number of regula falsi steps after a sampled hit; method sampled only.</source>
        <translation>Regula-falsi-Schritte nach einem abgetasteten Treffer; nur bei Verfahren Abgetastet.</translation>
    </message>
    <message>
        <source>Minimum length of ridge and valley lines. Shorter lines, and those below 3 % of the image width, fade out. auto is the radius of the least curvature drawn.</source>
        <translation>Mindestlänge der Grat- und Tallinien. Kürzere und solche unter 3 % der Bildbreite blenden aus. auto ist der Radius der geringsten gezeichneten Krümmung.</translation>
    </message>
    <message>
        <source>Distance from the isovalue within which sampling is denser, for method sampled only. auto is the typical change of value from one sample to the next.</source>
        <translation>Abstand vom Isowert, innerhalb dessen die Abtastung dichter ist, nur bei Verfahren Abgetastet. auto ist die typische Änderung des Werts von einem Abtastpunkt zum nächsten.</translation>
    </message>
    <message>
        <source>Shows the environment behind the surface.</source>
        <translation>Zeigt die Umgebung hinter der Oberfläche.</translation>
    </message>
    <message>
        <source>Shows the largest value within this depth below the surface; 0 shows the value at the surface.</source>
        <translation>Zeigt den größten Wert bis zu dieser Tiefe unter der Oberfläche; 0 zeigt den Wert auf der Oberfläche.</translation>
    </message>
    <message>
        <source>Grain size of the noise that the streaks follow.</source>
        <translation>Korngröße des Rauschens, dem die Streifen folgen.</translation>
    </message>
    <message>
        <source>Size of the solid texture&apos;s features; auto is a tenth of the volume&apos;s diagonal.</source>
        <translation>Größe der Muster der Festkörpertextur; auto ist ein Zehntel der Diagonale des Volumens.</translation>
    </message>
    <message>
        <source>Standard deviation of a voxel&apos;s noise, from which the confidence in curvature is computed; auto estimates it from the volume.</source>
        <translation>Standardabweichung des Rauschens eines Voxels, aus der die Konfidenz der Krümmung berechnet wird; auto schätzt sie aus dem Volumen.</translation>
    </message>
    <message>
        <source>Maximum number of principal components to which baked transfer is compressed.</source>
        <translation>Höchstzahl der Hauptkomponenten, auf die gespeicherter Transfer verdichtet wird.</translation>
    </message>
    <message>
        <source>Strength of streaks along the principal curvature directions, over any look.</source>
        <translation>Stärke der Streifen längs der Hauptkrümmungsrichtungen, über jeder Darstellung.</translation>
    </message>
    <message>
        <source>Strength of ridge and valley lines: curvature maxima across the line.</source>
        <translation>Stärke der Grat- und Tallinien: Maxima der Krümmung quer zur Linie.</translation>
    </message>
    <message>
        <source>Strength of suggestive contours: lines that would be silhouettes in a nearby view.</source>
        <translation>Stärke der angedeuteten Konturen: Linien, die aus einem nahen Blickwinkel Umrisse wären.</translation>
    </message>
    <message>
        <source>Strength of the highlight.</source>
        <translation>Stärke des Glanzlichts.</translation>
    </message>
    <message>
        <source>Strength of the key light&apos;s hard shadow, found with one exact shadow ray per pixel.</source>
        <translation>Stärke des harten Schattens des Hauptlichts, bestimmt mit einem exakten Schattenstrahl je Pixel.</translation>
    </message>
    <message>
        <source>Strength of silhouette lines; auto is 0.5 under tone shading, otherwise 0.</source>
        <translation>Stärke der Umrisslinien; auto ist 0,5 bei Warm-Kalt-Schattierung, sonst 0.</translation>
    </message>
    <message>
        <source>SeriesInstanceUID of the series to read from a DICOM folder; empty selects the series with the most slices.</source>
        <translation>SeriesInstanceUID der Serie, die aus einem DICOM-Ordner gelesen wird; leer wählt die Serie mit den meisten Schichten.</translation>
    </message>
    <message>
        <source>Colour map over the second volume&apos;s values; auto is viridis.</source>
        <translation>Farbskala über den Werten des zweiten Volumens; auto ist Viridis.</translation>
    </message>
    <message>
        <source>Colour map over the isovalue; auto is viridis.</source>
        <translation>Farbskala über dem Isowert; auto ist Viridis.</translation>
    </message>
    <message>
        <source>Diffuse reflectance of the surface.</source>
        <translation>Diffuser Reflexionsgrad der Fläche.</translation>
    </message>
    <message>
        <source>Upward direction of the image; auto is superior (y for meshes), or anterior (the front) when looking along it.</source>
        <translation>Richtung, die im Bild nach oben zeigt; auto ist superior (y bei Netzen) oder anterior (vorn), wenn entlang davon geblickt wird.</translation>
    </message>
    <message>
        <source>Sampling sequence of path directions: scrambled Sobol points, Roberts&apos; R2 shifted per texel, or independent random numbers.</source>
        <translation>Folge der Pfadrichtungen: verwürfelte Sobol-Punkte, Roberts’ R2 mit einer Verschiebung je Texel oder unabhängige Zufallszahlen.</translation>
    </message>
    <message>
        <source>With gi.mode=auto, bakes light such that the environment can be rotated or exchanged without another bake.</source>
        <translation>Speichert bei gi.mode=auto Licht so, dass die Umgebung ohne neue Berechnung gedreht oder getauscht werden kann.</translation>
    </message>
    <message>
        <source>Isovalue at the lower end of that map; auto is the volume&apos;s minimum.</source>
        <translation>Isowert am unteren Ende dieser Skala; auto ist das Minimum des Volumens.</translation>
    </message>
    <message>
        <source>Isovalue at the upper end of that map; auto is the volume&apos;s maximum.</source>
        <translation>Isowert am oberen Ende dieser Skala; auto ist das Maximum des Volumens.</translation>
    </message>
    <message>
        <source>Isovalue of the second volume, in its own units; auto uses the suggested one.</source>
        <translation>Isowert des zweiten Volumens, in dessen Einheiten; auto verwendet den vorgeschlagenen.</translation>
    </message>
    <message>
        <source>Isovalues of interest, low and high; auto is the isovalue ± a twentieth of the volume&apos;s range.</source>
        <translation>Wichtige Isowerte, von und bis; auto ist der Isowert ± ein Zwanzigstel des Wertebereichs.</translation>
    </message>
    <message>
        <source>Equirectangular environment map (.hdr, .exr, ...), with its first row at the top; if empty, none is used.</source>
        <translation>Äquirektangulares Umgebungsbild (.hdr, .exr, ...) mit der ersten Zeile oben; ist es leer, wird keines verwendet.</translation>
    </message>
    <message>
        <source>Built-in environment, used if there is neither an environment map nor a constant environment.</source>
        <translation>Eingebaute Umgebung, wenn es weder ein Umgebungsbild noch eine konstante Umgebung gibt.</translation>
    </message>
    <message>
        <source>Quantity at the lower end of the colour map; auto derives it from the values on the surface.</source>
        <translation>Größe am unteren Ende der Farbskala; auto folgt aus den Werten auf der Oberfläche.</translation>
    </message>
    <message>
        <source>Quantity at the upper end of the colour map; auto derives it from the values on the surface.</source>
        <translation>Größe am oberen Ende der Farbskala; auto folgt aus den Werten auf der Oberfläche.</translation>
    </message>
    <message>
        <source>Fraction of light samples drawn from the environment instead of the surface (MIS). auto is 0.75 under an environment map, 0.5 with more than one bounce.</source>
        <translation>Anteil der Lichtproben, die nach der Umgebung statt nach der Oberfläche gezogen werden (MIS). auto ist 0,75 unter einem Umgebungsbild, 0,5 bei mehr als einer Reflexion.</translation>
    </message>
    <message>
        <source>Radiance of a constant environment, used if there is no environment map; auto uses none.</source>
        <translation>Strahldichte einer konstanten Umgebung, wenn es kein Umgebungsbild gibt; auto verwendet keine.</translation>
    </message>
    <message>
        <source>Interpolation of the second volume.</source>
        <translation>Interpolation des zweiten Volumens.</translation>
    </message>
    <message>
        <source>Interpolant for gradients and curvature: trilinear, the cubic B-spline, or the interpolating cubic B-spline.</source>
        <translation>Interpolant für Gradienten und Krümmung: trilinear, der kubische B-Spline oder der interpolierende kubische B-Spline.</translation>
    </message>
    <message>
        <source>Interpolation between voxels in slices and on caps.</source>
        <translation>Interpolation zwischen den Voxeln in Schichten und auf Schnittflächen.</translation>
    </message>
    <message>
        <source>Interpolant whose surface is drawn: trilinear, cubic B-spline or interpolating cubic B-spline. The B-spline is the smoothest, but shrinks thin structures until they vanish. The interpolating one keeps wires, twigs and vessels connected where trilinear hits draw beads.</source>
        <translation>Interpolant, dessen Fläche gezeichnet wird: trilinear, kubischer B-Spline oder interpolierender kubischer B-Spline. Der B-Spline ist am glattesten, lässt aber dünne Strukturen schrumpfen, bis sie verschwinden. Der interpolierende hält Drähte, Zweige und Gefäße zusammen, wo trilineare Treffer Perlen zeichnen.</translation>
    </message>
    <message>
        <source>Interpolant of final images if hit.field is trilinear: same, or the interpolating B-spline. auto uses the spline if more than a tenth of the visible surface deviates by over a tenth of a voxel. AOVs and baked light use hit.field.</source>
        <translation>Interpolant fertiger Bilder, wenn hit.field trilinear ist: derselbe oder der interpolierende B-Spline. auto nimmt den Spline, wenn mehr als ein Zehntel der sichtbaren Oberfläche um über ein Zehntel Voxel abweicht. AOVs und gespeichertes Licht bleiben bei hit.field.</translation>
    </message>
    <message>
        <source>Scale σ of the normals used by shading and contours, as derivatives.scale.</source>
        <translation>Skala σ der Normalen für Schattierung und Konturen, wie derivatives.scale.</translation>
    </message>
    <message>
        <source>Scale σ of curvature, lines and flow: standard deviation of the isotropic Gaussian that smooths the volume before second derivatives. 0 does not smooth; auto chooses from the noise.</source>
        <translation>Skala σ von Krümmung, Linien und Strömung: Standardabweichung der isotropen Gauß-Glättung des Volumens vor den zweiten Ableitungen. 0 glättet nicht; auto wählt nach dem Rauschen.</translation>
    </message>
    <message>
        <source>Second volume of the Boolean operation, given as in source.path. A phantom without SIZE uses the first volume&apos;s grid.</source>
        <translation>Zweites Volumen der booleschen Operation, angegeben wie source.path. Ein Phantom ohne GRÖSSE übernimmt das Gitter des ersten.</translation>
    </message>
    <message>
        <source>Shading of looks that give a colour: the curvature maps, crevice shading and flow; gi is baked global illumination.</source>
        <translation>Schattierung der Darstellungen, die eine Farbe geben: Krümmungen, Vertiefungen und Strömung; gi ist gespeicherte globale Beleuchtung.</translation>
    </message>
    <message>
        <source>Value at the lower end of the map; auto derives it from the values on the surface.</source>
        <translation>Wert am unteren Ende der Skala; auto folgt aus den Werten auf der Oberfläche.</translation>
    </message>
    <message>
        <source>Value at the upper end of the map; auto derives it from the values on the surface.</source>
        <translation>Wert am oberen Ende der Skala; auto folgt aus den Werten auf der Oberfläche.</translation>
    </message>
    <message>
        <source>Window level: the value shown as middle grey in slices and on caps; auto derives it from the volume.</source>
        <translation>Fenstermitte: der Wert, der in Schichten und auf Schnittflächen mittelgrau erscheint; auto folgt aus dem Volumen.</translation>
    </message>
    <message>
        <source>Layout of the volume on the GPU: one texture, or bricks of which only those needed are resident. auto uses one texture if it fits.</source>
        <translation>Anordnung des Volumens auf der Grafikkarte: eine Textur oder Blöcke, von denen nur die nötigen geladen sind. auto nimmt eine Textur, wenn sie passt.</translation>
    </message>
    <message>
        <source>Volume to draw: a file, a DICOM folder, a triangle mesh, or phantom:NAME[:SIZE].</source>
        <translation>Gezeichnetes Volumen: eine Datei, ein DICOM-Ordner, ein Dreiecksnetz oder phantom:NAME[:GRÖSSE].</translation>
    </message>
    <message>
        <source>Width of the isosurfaces&apos; contours in slices; 0 draws none.</source>
        <translation>Breite der Konturen der Isoflächen in Schichten; 0 zeichnet keine.</translation>
    </message>
    <message>
        <source>Colour map of slices and caps; auto is gray.</source>
        <translation>Farbskala von Schichten und Schnittflächen; auto ist Grau.</translation>
    </message>
    <message>
        <source>Width of the isolines.</source>
        <translation>Breite der Isolinien.</translation>
    </message>
    <message>
        <source>CPU threads that compute light; auto is one per core.</source>
        <translation>CPU-Threads, die Licht berechnen; auto ist einer je Kern.</translation>
    </message>
    <message>
        <source>Tilt of the environment before its rotation; positive values raise light from the front.</source>
        <translation>Neigung der Umgebung vor ihrer Drehung; positive Werte heben Licht von vorn.</translation>
    </message>
    <message>
        <source>Tone shading: colour of parts that face away from the light.</source>
        <translation>Warm-Kalt-Schattierung: Farbe von Stellen, die vom Licht abgewandt sind.</translation>
    </message>
    <message>
        <source>Tone shading: colour of parts that face the light.</source>
        <translation>Warm-Kalt-Schattierung: Farbe von Stellen, die dem Licht zugewandt sind.</translation>
    </message>
    <message>
        <source>Direction towards a distant light, world axes; any length but zero.</source>
        <translation>Richtung zu einem fernen Licht, Achsen des Raums; jede Länge außer null.</translation>
    </message>
    <message>
        <source>Direction towards the key light, in camera axes (right, up, towards the viewer) or world axes; any length but zero.</source>
        <translation>Richtung zum Hauptlicht, in Achsen der Kamera (rechts, oben, zum Betrachter) oder des Raums; jede Länge außer null.</translation>
    </message>
    <message>
        <source>Rotation of the environment about the vertical, counterclockwise as seen from above.</source>
        <translation>Drehung der Umgebung um die Senkrechte, von oben gesehen gegen den Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Rotation from the environment&apos;s axes to the world&apos;s, before azimuth and elevation.</source>
        <translation>Drehung von den Achsen der Umgebung zu denen des Raums, vor Azimut und Höhenwinkel.</translation>
    </message>
    <message>
        <source>Two opposite corners &quot;x,y,z; x,y,z&quot; of the clip box, which removes everything outside it; empty removes nothing.</source>
        <translation>Zwei gegenüberliegende Ecken „x,y,z; x,y,z“ des Schnittquaders, der alles außerhalb entfernt; leer entfernt nichts.</translation>
    </message>
    <message>
        <source>Up to six clip planes &quot;px,py,pz nx,ny,nz; ...&quot;, a point and a normal each; they remove the side that the normal points to.</source>
        <translation>Bis zu sechs Schnittebenen „px,py,pz nx,ny,nz; ...“, je ein Punkt und eine Normale; sie entfernen die Seite, zu der die Normale zeigt.</translation>
    </message>
    <message>
        <source>Vertical field of view; an orthographic image has this height at the target&apos;s distance.</source>
        <translation>Senkrechter Bildwinkel; ein orthographisches Bild hat diese Höhe in der Entfernung des Ziels.</translation>
    </message>
    <message>
        <source>Projection through a slab: maximum (MIP), minimum (MinIP) or average along its normal.</source>
        <translation>Projektion durch eine dicke Schicht: Maximum (MIP), Minimum (MinIP) oder Mittel längs ihrer Normalen.</translation>
    </message>
    <message>
        <source>Device that computes hits and derivatives: the GPU, or the CPU (exact hits only). auto uses the CPU if OpenGL is software.</source>
        <translation>Gerät, das Treffer und Ableitungen berechnet: die Grafikkarte oder die CPU (nur exakte Treffer). auto nimmt die CPU, wenn OpenGL Software ist.</translation>
    </message>
    <message>
        <source>Caps of clip planes and boxes: none, the voxel values where the inside is cut, or the voxel values of the whole face.</source>
        <translation>Füllung der Schnittebenen und -quader: keine, die Werte der Voxel, wo das Innere geschnitten ist, oder die Werte der Voxel auf der ganzen Fläche.</translation>
    </message>
    <message>
        <source>Colour of the fog; auto is the background.</source>
        <translation>Farbe des Nebels; auto ist der Hintergrund.</translation>
    </message>
    <message>
        <source>List of measurements: {kind, name, points, color, shown} each.</source>
        <translation>Liste der Messungen: je {kind, name, points, color, shown}.</translation>
    </message>
    <message>
        <source>Quantity that is baked: irradiance (static light), transfer (spherical harmonics, rotatable environment), vicinity (constant environment, no bounces) or shadow (no bounces). auto bakes the cheapest that the scene allows.</source>
        <translation>Gespeicherte Größe: Bestrahlungsstärke (festes Licht), Transfer (Kugelflächenfunktionen, drehbare Umgebung), Nachbarschaft (konstante Umgebung, keine Reflexionen) oder Schatten (keine Reflexionen). auto speichert die billigste, die die Szene zulässt.</translation>
    </message>
    <message>
        <source>Look (display mode): the shaded surface, or a quantity shown in colour.</source>
        <translation>Darstellung: die schattierte Oberfläche oder eine Größe in Farbe.</translation>
    </message>
    <message>
        <source>Position of a point or sphere light; auto is above the volume, towards the front and the left.</source>
        <translation>Position eines Punkt- oder Kugellichts; auto ist über dem Volumen, vorn und links.</translation>
    </message>
    <message>
        <source>Current time of the flow animation.</source>
        <translation>Zeitpunkt der Strömungsanimation.</translation>
    </message>
    <message>
        <source>Corner of the legend; auto is the corner that covers least of the surface.</source>
        <translation>Ecke der Legende; auto ist die Ecke, die am wenigsten von der Oberfläche verdeckt.</translation>
    </message>
    <message>
        <source>Point where the three slices meet; auto is the centre of the volume.</source>
        <translation>Punkt, in dem sich die drei Schichten treffen; auto ist die Mitte des Volumens.</translation>
    </message>
    <message>
        <source>Perspective (distant parts look smaller) or orthographic projection.</source>
        <translation>Perspektivische (Fernes sieht kleiner aus) oder orthographische Projektion.</translation>
    </message>
    <message>
        <source>Source of the isosurfaces&apos; reflectances: a colour per surface, or a colour map over the isovalue.</source>
        <translation>Quelle der Reflexionsgrade der Isoflächen: eine Farbe je Fläche oder eine Farbskala über dem Isowert.</translation>
    </message>
    <message>
        <source>Unit of the width of ridge and valley lines: pixels of the image, or mm on the surface.</source>
        <translation>Einheit der Breite der Grat- und Tallinien: Pixel im Bild oder mm auf der Oberfläche.</translation>
    </message>
    <message>
        <source>Fixes the key light to the viewer or to the volume.</source>
        <translation>Bindet das Hauptlicht an den Betrachter oder an das Volumen.</translation>
    </message>
    <message>
        <source>Display convention of axial and coronal slices: the patient&apos;s right on the left (radiological) or on the right (neurological).</source>
        <translation>Darstellung axialer und koronaler Schichten: die rechte Seite des Patienten links (radiologisch) oder rechts (neurologisch).</translation>
    </message>
    <message>
        <source>Channel to read from a file with several values per voxel; -1 reads the magnitude of the vector.</source>
        <translation>Kanal einer Datei mit mehreren Werten je Voxel; -1 liest den Betrag des Vektors.</translation>
    </message>
    <message>
        <source>Channel of the second volume, as source.component.</source>
        <translation>Kanal des zweiten Volumens, wie source.component.</translation>
    </message>
    <message>
        <source>Time step of the second volume, as source.time_step.</source>
        <translation>Zeitschritt des zweiten Volumens, wie source.time_step.</translation>
    </message>
    <message>
        <source>Side of the isovalue that is solid; the normal points away from it.</source>
        <translation>Seite des Isowerts, die fest ist; die Normale zeigt von ihr weg.</translation>
    </message>
    <message>
        <source>Texels that are lit: all, those needed for the isovalues of gi.band, or the visible ones.</source>
        <translation>Beleuchtete Texel: alle, die für die Isowerte von gi.band nötigen oder die sichtbaren.</translation>
    </message>
    <message>
        <source>Width of contour lines, uniform across the image.</source>
        <translation>Breite der Konturlinien, im ganzen Bild gleich.</translation>
    </message>
    <message>
        <source>Width of ridge and valley lines, in the unit of look.ridge_width_unit.</source>
        <translation>Breite der Grat- und Tallinien, in der Einheit von look.ridge_width_unit.</translation>
    </message>
    <message>
        <source>Hides the connected components that contain one of these world points.</source>
        <translation>Verbirgt die zusammenhängenden Teile, die einen dieser Punkte im Raum enthalten.</translation>
    </message>
    <message>
        <source>If not empty, shows only the connected components that contain one of these world points.</source>
        <translation>Zeigt, wenn nicht leer, nur die zusammenhängenden Teile, die einen dieser Punkte im Raum enthalten.</translation>
    </message>
    <message>
        <source>Draws a scale bar of a round length on the final image. In perspective it is valid at the depth of camera.target. The window always shows it.</source>
        <translation>Zeichnet einen Maßstab von runder Länge auf das fertige Bild. In der Perspektive gilt er in der Tiefe von camera.target. Das Fenster zeigt ihn immer.</translation>
    </message>
    <message>
        <source>Draws orientation labels at the edges of the final image: the ends of the patient&apos;s axes. If the patient orientation is unknown, they name the world&apos;s axes. The window always shows them.</source>
        <translation>Zeichnet Orientierungsbuchstaben an die Ränder des fertigen Bildes: die Enden der Achsen des Patienten. Ist die Orientierung des Patienten unbekannt, bezeichnen sie die Achsen des Raums. Das Fenster zeigt sie immer.</translation>
    </message>
    <message>
        <source>Pixels of the final image per pixel in which line and streak sizes are stated. For the same look in an image twice as large, use 2.</source>
        <translation>Pixel des fertigen Bildes je Pixel, in dem Größen von Linien und Streifen angegeben sind. 2 in einem doppelt so großen Bild erhält das Aussehen.</translation>
    </message>
    <message>
        <source>Leaves out the background of the final image; its alpha is the covered fraction of each pixel.</source>
        <translation>Lässt den Hintergrund des fertigen Bildes weg; sein Alpha ist der bedeckte Anteil jedes Pixels.</translation>
    </message>
    <message>
        <source>Writes the isovalues of the visible surfaces, with their unit, on the final image.</source>
        <translation>Schreibt die Isowerte der gezeigten Flächen mit ihrer Einheit auf das fertige Bild.</translation>
    </message>
    <message>
        <source>View-dependent opacity: factor on the opacity where the surface faces the viewer; edge-on the opacity is unchanged.</source>
        <translation>Blickabhängige Deckkraft: Faktor der Deckkraft, wo die Fläche zum Betrachter zeigt; von der Kante gesehen bleibt sie unverändert.</translation>
    </message>
    <message>
        <source>Name of the surface in lists and on the histogram.</source>
        <translation>Name der Fläche in Listen und im Histogramm.</translation>
    </message>
    <message>
        <source>Resolution level of a large file: 0 is full resolution, each further level halves it along each axis. Levels stored in the file are used; others are averaged.</source>
        <translation>Auflösungsstufe einer großen Datei: 0 ist die volle Auflösung, jede weitere Stufe halbiert sie je Achse. In der Datei gespeicherte Stufen werden verwendet, andere gemittelt.</translation>
    </message>
    <message>
        <source>Treats unreadable voxels of a chunked file as missing; otherwise the file is rejected.</source>
        <translation>Behandelt unlesbare Voxel einer Datei aus Blöcken als fehlend; sonst wird die Datei abgewiesen.</translation>
    </message>
    <message>
        <source>Writes a line on the final image for each omission or interpolation, such as hidden connected components or interpolated missing slices.</source>
        <translation>Schreibt für jede Auslassung oder Interpolation eine Zeile auf das fertige Bild, etwa für verborgene Teile oder interpolierte fehlende Schichten.</translation>
    </message>
    <message>
        <source>Point that the camera looks at and turns about; auto is the centre of the framed object.</source>
        <translation>Punkt, auf den die Kamera blickt und um den sie dreht; auto ist die Mitte des Objekts, das das Bild füllt.</translation>
    </message>
    <message>
        <source>Object that the automatic camera frames: the surface or the volume. A patient&apos;s surface and the volume are seen from the front, other surfaces from where most of them is visible.</source>
        <translation>Objekt, das die automatische Kamera ins Bild fasst: die Oberfläche oder das Volumen. Patienten und das Volumen zeigt sie von vorn, andere Oberflächen von dort, wo am meisten von ihnen zu sehen ist.</translation>
    </message>
    <message>
        <source>Position of the viewer; auto follows camera.frames.</source>
        <translation>Position des Betrachters; auto richtet sich nach camera.frames.</translation>
    </message>
    <message>
        <source>Kind of data: CT in Hounsfield or other units, MR, distance field …; auto derives it from the file and its values. Presets and the first isovalue depend on it.</source>
        <translation>Art der Daten: CT in Hounsfield-Einheiten oder in anderen, MR, Abstandsfeld …; auto entscheidet nach Datei und Werten. Vorlagen und der erste Isowert hängen davon ab.</translation>
    </message>
    <message>
        <source>Two opposite corners &quot;x,y,z; x,y,z&quot; of each removed box, at most eight boxes. Everything inside them is clipped; they may extend beyond the volume.</source>
        <translation>Je zwei gegenüberliegende Ecken „x,y,z; x,y,z“ der entfernten Quader, höchstens acht. Alles in ihnen wird weggeschnitten; sie dürfen über das Volumen hinausreichen.</translation>
    </message>
    <message>
        <source>How the window shows images: as textures that stay on the graphics card, or as pixels copied to main memory. auto uses textures on a graphics card. A change to textures may need a restart.</source>
        <translation>Wie das Fenster Bilder zeigt: als Texturen, die auf der Grafikkarte bleiben, oder als Pixel, die in den Hauptspeicher kopiert werden. auto nimmt Texturen, wo es eine Grafikkarte gibt. Ein Wechsel zu Texturen kann einen Neustart brauchen.</translation>
    </message>
    <message>
        <source>Gloss under global illumination: reflectance of the surface seen head on. Water and skin have 0.02 to 0.04, teeth 0.06, metal 0.5 to 0.9; 0 is matt.</source>
        <translation>Glanz unter globaler Beleuchtung: Reflexionsgrad der Fläche bei senkrechtem Blick. Wasser und Haut haben 0,02 bis 0,04, Zähne 0,06, Metall 0,5 bis 0,9; 0 ist matt.</translation>
    </message>
    <message>
        <source>Roughness of that gloss: small values reflect sharply, 1 spreads over half the sky.</source>
        <translation>Rauheit dieses Glanzes: kleine Werte spiegeln scharf, 1 verteilt über den halben Himmel.</translation>
    </message>
    <message>
        <source>Time step to read from a file with several, counted from 0; a fraction blends a step with the next.</source>
        <translation>Zu lesender Zeitschritt einer Datei mit mehreren, von 0 an gezählt; ein Bruchteil blendet einen Schritt in den nächsten.</translation>
    </message>
    <message>
        <source>Tone curve of final images: linear clips at white; filmic rolls highlights off as film does. auto is filmic under global illumination, otherwise linear. Linear files (EXR) are not affected.</source>
        <translation>Tonwertkurve fertiger Bilder: linear schneidet bei Weiß ab, filmic rundet Lichter ab wie ein Film. auto ist filmic unter globaler Beleuchtung, sonst linear. Lineare Dateien (EXR) sind nicht betroffen.</translation>
    </message>
    <message>
        <source>Transfer function of crevice shading: control points [position, r, g, b], from the deepest hollow at 0 to the open surface at 1; the colours multiply the surface&apos;s own. auto darkens hollows to brown.</source>
        <translation>Transferfunktion der Vertiefungsschattierung: Kontrollpunkte [Position, r, g, b] von der tiefsten Vertiefung bei 0 bis zur offenen Fläche bei 1; die Farben werden mit der eigenen der Fläche multipliziert. auto dunkelt Vertiefungen braun ab.</translation>
    </message>
    <message>
        <source>Transfer function of your own for the quantity: control points [position, r, g, b] in linear RGB, positions as fractions of the range; auto uses look.colormap.</source>
        <translation>Eigene Transferfunktion für die Größe: Kontrollpunkte [Position, r, g, b] in linearem RGB, Positionen als Bruchteile des Bereichs; auto nimmt look.colormap.</translation>
    </message>
    <message>
        <source>Weight of the second volume where source.csg is blend: 0 shows the first volume&apos;s surface, 1 the second&apos;s.</source>
        <translation>Gewicht des zweiten Volumens, wenn source.csg blend ist: 0 zeigt die Fläche des ersten, 1 die des zweiten.</translation>
    </message>
    <message>
        <source>Work of the renderer drawn over the surface: blocks that rays enter, bricks in graphics memory, or lit texels.</source>
        <translation>Arbeit des Renderers, über die Fläche gezeichnet: Blöcke, die Strahlen durchlaufen, Bricks im Grafikspeicher oder beleuchtete Texel.</translation>
    </message>
    <message>
        <source>Basis of automatic exposure: the light that the surface receives, whatever its colour, or the lights. The surface is that of the image when a volume is drawn, and that of the front in sessions and the window. The lights make an unoccluded white surface nearly white. brightness: the light that leaves the front, with its colour, as before session version 9.</source>
        <translation>Grundlage der automatischen Belichtung: das Licht, das die Fläche empfängt, gleich welcher Farbe, oder die Lichtquellen. Gemessen wird die Fläche im Bild, wenn ein Volumen gezeichnet wird, und die Vorderansicht in Sitzungen und im Fenster. Die Lichtquellen machen eine unverdeckte weiße Fläche fast weiß. brightness: das Licht, das die Vorderansicht mit ihrer Farbe verlässt, wie vor Sitzungsversion 9.</translation>
    </message>
    <message>
        <source>Shows the shadow of the surface on the ground: a horizontal plane under it, seen from above.</source>
        <translation>Zeigt den Schatten der Fläche auf dem Boden: einer waagerechten Ebene unter ihr, von oben gesehen.</translation>
    </message>
    <message>
        <source>Surface on which texels are lit. own: each sample&apos;s own isosurface, for any isovalue. shown: the displayed isosurface, which is more accurate, but for one isovalue. auto is shown with gi.extent=view, otherwise own. With several isosurfaces that are not too transparent, it is own.</source>
        <translation>Fläche, auf der Texel beleuchtet werden. own: die eigene Isofläche jedes Abtastwerts, für jeden Isowert. shown: die gezeigte Isofläche, was genauer ist, aber für einen Isowert. auto ist shown bei gi.extent=view, sonst own. Bei mehreren Isoflächen, die nicht zu durchsichtig sind, gilt own.</translation>
    </message>
    <message>
        <source>The light source casts shadows; off, its light reaches every point that faces it, and reflected light stays.</source>
        <translation>Die Lichtquelle wirft Schatten; aus: Ihr Licht erreicht jeden Punkt, der ihr zugewandt ist, und reflektiertes Licht bleibt.</translation>
    </message>
    <message>
        <source>The surface occludes the environment; off, its light reaches every point, and reflected light stays.</source>
        <translation>Die Fläche verdeckt die Umgebung; aus: Ihr Licht erreicht jeden Punkt, und reflektiertes Licht bleibt.</translation>
    </message>
    <message>
        <source>Applies clip planes and clip box to the surface.</source>
        <translation>Wendet Schnittebenen und Schnittquader auf die Fläche an.</translation>
    </message>
    <message>
        <source>Automatic isovalue of the first surface: the boundary of the whole object (skin in a scan of a head), or the clearest boundary inside it (often bone).</source>
        <translation>Automatischer Isowert der ersten Fläche: die Grenze des ganzen Objekts (Haut im Scan eines Kopfes) oder die deutlichste Grenze darin (oft Knochen).</translation>
    </message>
    <message>
        <source>Draws the surface.</source>
        <translation>Zeichnet die Fläche.</translation>
    </message>
    <message>
        <source>Draws two uncertainty surfaces: transparent isosurfaces at the isovalue ± this many standard deviations of the noise. They bound the shift due to noise; 0 draws none.</source>
        <translation>Zeichnet zwei Unsicherheitsflächen: durchsichtige Isoflächen beim Isowert ± so vielen Standardabweichungen des Rauschens. Sie begrenzen die Verschiebung durch Rauschen; 0 zeichnet keine.</translation>
    </message>
    <message>
        <source>Isovalue of the surface. auto: the first follows isosurface.suggestion, others take the histogram&apos;s next suggestion outside the first, or inside if there is none. Assigning it to a new ID makes a surface.</source>
        <translation>Isowert der Fläche. auto: die erste folgt isosurface.suggestion, andere nehmen den nächsten Vorschlag des Histogramms außerhalb der ersten, sonst innerhalb. Einer neuen ID zugewiesen, erzeugt er eine Fläche.</translation>
    </message>
    <message>
        <source>Kind of the light source: point, distant (directional) or sphere light. Assigning it to a new ID makes a light source.</source>
        <translation>Art der Lichtquelle: Punktlicht, fernes (gerichtetes) Licht oder Kugellicht. Einer neuen ID zugewiesen, erzeugt sie eine Lichtquelle.</translation>
    </message>
    <message>
        <source>Labels of a label map whose surface is drawn: numbers, ranges and names, as &quot;2,4-7,liver&quot;; empty draws all but 0.</source>
        <translation>Labels einer Labelkarte, deren Fläche gezeichnet wird: Zahlen, Bereiche und Namen, wie &quot;2,4-7,liver&quot;; leer zeichnet alle außer 0.</translation>
    </message>
    <message>
        <source>Name of the light source, for lists.</source>
        <translation>Name der Lichtquelle, für Listen.</translation>
    </message>
    <message>
        <source>File that names the labels, instead of what the volume states: .tsv, .ctbl, .label, .txt, .json.</source>
        <translation>Datei, die die Labels benennt, statt dessen, was das Volumen angibt: .tsv, .ctbl, .label, .txt, .json.</translation>
    </message>
    <message>
        <source>Smoothing of the surface of labels: standard deviation of the Gaussian. Every voxel&apos;s centre keeps its label whatever it is; 0 shows the voxels&apos; own steps.</source>
        <translation>Glättung der Fläche von Labels: Standardabweichung der Gaußfunktion. Die Mitte jedes Voxels behält in jedem Fall ihr Label; 0 zeigt die Stufen der Voxel.</translation>
    </message>
    <message>
        <source>Switches the light source on.</source>
        <translation>Schaltet die Lichtquelle ein.</translation>
    </message>
    <message>
        <source>Labels of a label map that this surface encloses, as in source.labels; the first surface without any encloses all that no other names. Assigning it to a new ID makes a surface.</source>
        <translation>Labels einer Segmentierung, die diese Fläche umschließt, wie in source.labels; die erste Fläche ohne Angabe umschließt alle, die keine andere nennt. Einer neuen ID zugewiesen, legt es eine Fläche an.</translation>
    </message>
    <message>
        <source>Smoothing of this surface of labels, as in source.smoothing; auto is that.</source>
        <translation>Glättung dieser Fläche von Labels wie in source.smoothing; auto ist diese.</translation>
    </message>
    <message>
        <source>Gives each label on the surface its own colour; off, the surface has its albedo.</source>
        <translation>Gibt jedem Label auf der Fläche seine eigene Farbe; aus, hat die Fläche ihre Albedo.</translation>
    </message>
</context>
<context>
    <name>units</name>
    <message>
        <source>/mm</source>
        <translation>/mm</translation>
    </message>
    <message>
        <source>/mm, 1/mm² or 1</source>
        <translation>/mm, 1/mm² oder 1</translation>
    </message>
    <message>
        <source>/s</source>
        <translation>/s</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
    <message>
        <source>1/mm, 1/mm² or 1</source>
        <translation>1/mm, 1/mm² oder 1</translation>
    </message>
    <message>
        <source>1/s</source>
        <translation>1/s</translation>
    </message>
    <message>
        <source>MiB</source>
        <translation>MiB</translation>
    </message>
    <message>
        <source>bits per number</source>
        <translation>Bit je Zahl</translation>
    </message>
    <message>
        <source>bounces</source>
        <translation>Reflexionen</translation>
    </message>
    <message>
        <source>data units</source>
        <translation>Einheiten der Daten</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>its data units</source>
        <translation>Einheiten seiner Daten</translation>
    </message>
    <message>
        <source>linear RGB</source>
        <translation>lineares RGB</translation>
    </message>
    <message>
        <source>linear RGB radiance</source>
        <translation>Strahldichte in linearem RGB</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>numbers per texel</source>
        <translation>Zahlen je Texel</translation>
    </message>
    <message>
        <source>paths per texel</source>
        <translation>Pfade je Texel</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>pixels or mm</source>
        <translation>Pixel oder mm</translation>
    </message>
    <message>
        <source>quaternion w,x,y,z</source>
        <translation>Quaternion w,x,y,z</translation>
    </message>
    <message>
        <source>rays per pixel and axis</source>
        <translation>Strahlen je Pixel und Achse</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>samples per voxel</source>
        <translation>Abtastungen je Voxel</translation>
    </message>
    <message>
        <source>standard deviations</source>
        <translation>Standardabweichungen</translation>
    </message>
    <message>
        <source>standard deviations of the noise</source>
        <translation>Standardabweichungen des Rauschens</translation>
    </message>
    <message>
        <source>stops</source>
        <translation>Blendenstufen</translation>
    </message>
    <message>
        <source>texels per voxel and axis</source>
        <translation>Texel je Voxel und Achse</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>Voxel</translation>
    </message>
</context>
<context>
    <name>views</name>
    <message>
        <source>+X</source>
        <translation>+X</translation>
    </message>
    <message>
        <source>+Y</source>
        <translation>+Y</translation>
    </message>
    <message>
        <source>+Z</source>
        <translation>+Z</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>−X</source>
        <translation>−X</translation>
    </message>
    <message>
        <source>−Y</source>
        <translation>−Y</translation>
    </message>
    <message>
        <source>−Z</source>
        <translation>−Z</translation>
    </message>
</context>
<context>
    <name>words</name>
    <message>
        <source>Above</source>
        <translation>Darüber</translation>
    </message>
    <message>
        <source>Crevice shading</source>
        <translation>Vertiefungen</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Umgebungslicht</translation>
    </message>
    <message>
        <source>Hemisphere lighting</source>
        <translation>Himmelslicht</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Background bottom</source>
        <translation>Hintergrund unten</translation>
    </message>
    <message>
        <source>Background top</source>
        <translation>Hintergrund oben</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Darunter</translation>
    </message>
    <message>
        <source>Blinn-Phong</source>
        <translation>Blinn-Phong</translation>
    </message>
    <message>
        <source>Blue–orange</source>
        <translation>Blau–orange</translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation>Reflexionen</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Box rotation</source>
        <translation>Drehung des Quaders</translation>
    </message>
    <message>
        <source>Bricks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Building blocks</source>
        <translation>Blöcke werden gebildet</translation>
    </message>
    <message>
        <source>Built-in light</source>
        <translation>Eingebautes Licht</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Cap</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Clipped</source>
        <translation>Geschnitten</translation>
    </message>
    <message>
        <source>Closest isovalue</source>
        <translation>Nächster Isowert</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour source</source>
        <translation>Farbquelle</translation>
    </message>
    <message>
        <source>Colour high</source>
        <translation>Farbe oben</translation>
    </message>
    <message>
        <source>Colour low</source>
        <translation>Farbe unten</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Farbskala</translation>
    </message>
    <message>
        <source>Colours of κ₁ and κ₂</source>
        <translation>Farben von κ₁ und κ₂</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Component bits</source>
        <translation>Bit je Komponente</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Contour colour</source>
        <translation>Konturfarbe</translation>
    </message>
    <message>
        <source>Contour width</source>
        <translation>Konturbreite</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Convention</source>
        <translation>Konvention</translation>
    </message>
    <message>
        <source>Cool–warm</source>
        <translation>Kalt–warm</translation>
    </message>
    <message>
        <source>Counting values</source>
        <translation>Werte werden gezählt</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>Boolean operation</source>
        <translation>Boolesche Operation</translation>
    </message>
    <message>
        <source>Second volume</source>
        <translation>Zweites Volumen</translation>
    </message>
    <message>
        <source>Second isovalue</source>
        <translation>Zweiter Isowert</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Kubisch</translation>
    </message>
    <message>
        <source>Cubic interpolating</source>
        <translation>Kubisch interpolierend</translation>
    </message>
    <message>
        <source>Curvedness</source>
        <translation>Krümmungsstärke</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Directional</source>
        <translation>Fern (gerichtet)</translation>
    </message>
    <message>
        <source>Edge offset</source>
        <translation>Kantenversatz</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhenwinkel</translation>
    </message>
    <message>
        <source>Environment share</source>
        <translation>Anteil der Umgebung</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Umfang der Berechnung</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Augpunkt</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Voxel access</source>
        <translation>Voxelzugriff</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Strömung</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>Fog colour</source>
        <translation>Nebelfarbe</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Voll</translation>
    </message>
    <message>
        <source>Gaussian curvature</source>
        <translation>Gaußsche Krümmung</translation>
    </message>
    <message>
        <source>Uncertainty surfaces</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>Uncertainty opacity</source>
        <translation>Deckkraft der Unsicherheit</translation>
    </message>
    <message>
        <source>Global illumination</source>
        <translation>Globale Beleuchtung</translation>
    </message>
    <message>
        <source>GPU</source>
        <translation>GPU</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Körnung</translation>
    </message>
    <message>
        <source>Gray</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Gyroid</source>
        <translation>Gyroid</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>Halbe Genauigkeit</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation>Kameralicht</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Obere Grenze</translation>
    </message>
    <message>
        <source>Inferno</source>
        <translation>Inferno</translation>
    </message>
    <message>
        <source>Back-face tint</source>
        <translation>Tönung der Rückseite</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Intersection</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>Irradiance</source>
        <translation>Bestrahlungsstärke</translation>
    </message>
    <message>
        <source>Isoline width</source>
        <translation>Breite der Isolinien</translation>
    </message>
    <message>
        <source>Isolines</source>
        <translation>Isolinien</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Größte behalten</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Lambert</source>
        <translation>Lambert</translation>
    </message>
    <message>
        <source>Lattice scale</source>
        <translation>Gitterauflösung</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Legend corner</source>
        <translation>Ecke der Legende</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Fenstermitte</translation>
    </message>
    <message>
        <source>Environment map</source>
        <translation>Umgebungsbild</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Lichter</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Untere Grenze</translation>
    </message>
    <message>
        <source>Lower left</source>
        <translation>Unten links</translation>
    </message>
    <message>
        <source>Lower right</source>
        <translation>Unten rechts</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Phantom wird erzeugt</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>Marmor</translation>
    </message>
    <message>
        <source>Marschner–Lobb</source>
        <translation>Marschner-Lobb</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>Mittlere Krümmung</translation>
    </message>
    <message>
        <source>Measuring distances</source>
        <translation>Abstände werden gemessen</translation>
    </message>
    <message>
        <source>Mesh voxels</source>
        <translation>Voxel des Netzes</translation>
    </message>
    <message>
        <source>Metering</source>
        <translation>Messung der Belichtung</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Rotatable</source>
        <translation>Drehbar</translation>
    </message>
    <message>
        <source>Near factor</source>
        <translation>Faktor nahe dem Isowert</translation>
    </message>
    <message>
        <source>Near threshold</source>
        <translation>Schwelle nahe dem Isowert</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Nächster</translation>
    </message>
    <message>
        <source>Neurological</source>
        <translation>Neurologisch</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Uncertainty band</source>
        <translation>Band der Unsicherheit</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Normal scale</source>
        <translation>Skala der Normalen</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Only</source>
        <translation>Nur diese</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>Orthographisch</translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation>Bedeckt</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Dateipfad</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektivisch</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Wird vorbereitet</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Purple–green</source>
        <translation>Lila–grün</translation>
    </message>
    <message>
        <source>R11G11B10</source>
        <translation>R11G11B10</translation>
    </message>
    <message>
        <source>R2</source>
        <translation>R2</translation>
    </message>
    <message>
        <source>Radiological</source>
        <translation>Radiologisch</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>Range high</source>
        <translation>Bereich bis</translation>
    </message>
    <message>
        <source>Range low</source>
        <translation>Bereich von</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Rohdaten</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Refinements</source>
        <translation>Verfeinerungen</translation>
    </message>
    <message>
        <source>Hits at rest</source>
        <translation>Treffer in Ruhe</translation>
    </message>
    <message>
        <source>Ridge colour</source>
        <translation>Farbe der Grate</translation>
    </message>
    <message>
        <source>Ridge length</source>
        <translation>Länge der Grate</translation>
    </message>
    <message>
        <source>Ridge threshold</source>
        <translation>Schwelle der Grate</translation>
    </message>
    <message>
        <source>Ridge width</source>
        <translation>Breite der Grate</translation>
    </message>
    <message>
        <source>Ridge width unit</source>
        <translation>Einheit der Breite</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Grate und Täler</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Roulette depth</source>
        <translation>Roulette ab Reflexion</translation>
    </message>
    <message>
        <source>SH order</source>
        <translation>SH-Ordnung</translation>
    </message>
    <message>
        <source>SH window</source>
        <translation>SH-Fenster</translation>
    </message>
    <message>
        <source>Saddle</source>
        <translation>Sattel</translation>
    </message>
    <message>
        <source>Same</source>
        <translation>Dieselbe</translation>
    </message>
    <message>
        <source>Sampled</source>
        <translation>Abgetastet</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Pfade</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchstrecke</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Zahlenfolge</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Shape index</source>
        <translation>Formindex</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Blätter</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Glanzexponent</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Show as background</source>
        <translation>Als Hintergrund zeigen</translation>
    </message>
    <message>
        <source>Sky colour</source>
        <translation>Himmelsfarbe</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Dicke der Schicht</translation>
    </message>
    <message>
        <source>Slab mode</source>
        <translation>Projektion der dicken Schicht</translation>
    </message>
    <message>
        <source>Minimum volume</source>
        <translation>Kleinstes Volumen</translation>
    </message>
    <message>
        <source>Sobol (Owen)</source>
        <translation>Sobol (Owen)</translation>
    </message>
    <message>
        <source>Reference frame</source>
        <translation>Bezugssystem</translation>
    </message>
    <message>
        <source>Spectral</source>
        <translation>Spektral</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Glanzlicht</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Suggestive contours</source>
        <translation>Angedeutete Konturen</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Abend</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Überabtastung</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Texels</source>
        <translation>Texel</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Texture scale</source>
        <translation>Größe der Textur</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Tone</source>
        <translation>Warm-Kalt</translation>
    </message>
    <message>
        <source>Tone cool</source>
        <translation>Kalter Ton</translation>
    </message>
    <message>
        <source>Tone warm</source>
        <translation>Warmer Ton</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Transfer</translation>
    </message>
    <message>
        <source>Tricubic</source>
        <translation>Trikubisch</translation>
    </message>
    <message>
        <source>Trilinear</source>
        <translation>Trilinear</translation>
    </message>
    <message>
        <source>Two balls</source>
        <translation>Zwei Kugeln</translation>
    </message>
    <message>
        <source>Union</source>
        <translation>Vereinigung</translation>
    </message>
    <message>
        <source>Unlit</source>
        <translation>Unbeleuchtet</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Upper left</source>
        <translation>Oben links</translation>
    </message>
    <message>
        <source>Upper right</source>
        <translation>Oben rechts</translation>
    </message>
    <message>
        <source>Valley colour</source>
        <translation>Farbe der Täler</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Vicinity</source>
        <translation>Nachbarschaft</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Weighted</source>
        <translation>Gewichtet</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Fensterbreite</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Wires</source>
        <translation>Drähte</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>crevice shading</source>
        <translation>Vertiefungen</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>geringere Auflösung bei Bewegung</translation>
    </message>
    <message>
        <source>albedo</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>albedo high</source>
        <translation>Farbe oben</translation>
    </message>
    <message>
        <source>albedo low</source>
        <translation>Farbe unten</translation>
    </message>
    <message>
        <source>albedo map</source>
        <translation>Farbskala</translation>
    </message>
    <message>
        <source>albedo source</source>
        <translation>Farbquelle</translation>
    </message>
    <message>
        <source>ambient</source>
        <translation>Umgebungslicht</translation>
    </message>
    <message>
        <source>hemisphere lighting</source>
        <translation>Himmelslicht</translation>
    </message>
    <message>
        <source>animate</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>background bottom</source>
        <translation>Hintergrund unten</translation>
    </message>
    <message>
        <source>background top</source>
        <translation>Hintergrund oben</translation>
    </message>
    <message>
        <source>band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>below</source>
        <translation>Darunter</translation>
    </message>
    <message>
        <source>bounces</source>
        <translation>Reflexionen</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>box rotation</source>
        <translation>Drehung des Quaders</translation>
    </message>
    <message>
        <source>building blocks</source>
        <translation>Blöcke werden gebildet</translation>
    </message>
    <message>
        <source>cap</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>Geschnitten</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>colour map</source>
        <translation>Farbskala</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>component bits</source>
        <translation>Bit je Komponente</translation>
    </message>
    <message>
        <source>components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>contour colour</source>
        <translation>Konturfarbe</translation>
    </message>
    <message>
        <source>contour width</source>
        <translation>Konturbreite</translation>
    </message>
    <message>
        <source>contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>convention</source>
        <translation>Konvention</translation>
    </message>
    <message>
        <source>counting values</source>
        <translation>Werte werden gezählt</translation>
    </message>
    <message>
        <source>boolean operation</source>
        <translation>Boolesche Operation</translation>
    </message>
    <message>
        <source>second volume</source>
        <translation>Zweites Volumen</translation>
    </message>
    <message>
        <source>second isovalue</source>
        <translation>Zweiter Isowert</translation>
    </message>
    <message>
        <source>curvature points</source>
        <translation>Farben von κ₁ und κ₂</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>environment azimuth</source>
        <translation>Umgebung: Azimut</translation>
    </message>
    <message>
        <source>environment builtin</source>
        <translation>Umgebung: Eingebautes Licht</translation>
    </message>
    <message>
        <source>environment constant</source>
        <translation>Umgebung: Himmelsfarbe</translation>
    </message>
    <message>
        <source>environment elevation</source>
        <translation>Umgebung: Höhenwinkel</translation>
    </message>
    <message>
        <source>environment exposure</source>
        <translation>Umgebung: Belichtung</translation>
    </message>
    <message>
        <source>environment file</source>
        <translation>Umgebung: Umgebungsbild</translation>
    </message>
    <message>
        <source>environment moves</source>
        <translation>Umgebung: Drehbar</translation>
    </message>
    <message>
        <source>environment rotation</source>
        <translation>Umgebung: Drehung</translation>
    </message>
    <message>
        <source>environment share</source>
        <translation>Anteil der Umgebung</translation>
    </message>
    <message>
        <source>environment visible</source>
        <translation>Umgebung: Als Hintergrund zeigen</translation>
    </message>
    <message>
        <source>executor</source>
        <translation>Gerät für das Ray-Casting</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>extent</source>
        <translation>Umfang der Berechnung</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>Augpunkt</translation>
    </message>
    <message>
        <source>fade</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>voxel access</source>
        <translation>Voxelzugriff</translation>
    </message>
    <message>
        <source>field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>fog colour</source>
        <translation>Nebelfarbe</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>uncertainty surfaces</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>uncertainty opacity</source>
        <translation>Deckkraft der Unsicherheit</translation>
    </message>
    <message>
        <source>gpu budget mb</source>
        <translation>Grafikspeicher</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>ram budget mb</source>
        <translation>Arbeitsspeicher</translation>
    </message>
    <message>
        <source>grain</source>
        <translation>Körnung</translation>
    </message>
    <message>
        <source>headlight</source>
        <translation>Kameralicht</translation>
    </message>
    <message>
        <source>setup</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>fill light</source>
        <translation>Aufhelllicht</translation>
    </message>
    <message>
        <source>rim light</source>
        <translation>Kantenlicht</translation>
    </message>
    <message>
        <source>occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>occlusion radius</source>
        <translation>Reichweite der Verdeckung</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>high</source>
        <translation>Obere Grenze</translation>
    </message>
    <message>
        <source>back-face tint</source>
        <translation>Tönung der Rückseite</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>isoline width</source>
        <translation>Breite der Isolinien</translation>
    </message>
    <message>
        <source>isolines</source>
        <translation>Isolinien</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>Größte behalten</translation>
    </message>
    <message>
        <source>lattice scale</source>
        <translation>Gitterauflösung</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>legend corner</source>
        <translation>Ecke der Legende</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Fenstermitte</translation>
    </message>
    <message>
        <source>list</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>low</source>
        <translation>Untere Grenze</translation>
    </message>
    <message>
        <source>making the phantom</source>
        <translation>Phantom wird erzeugt</translation>
    </message>
    <message>
        <source>measuring distances</source>
        <translation>Abstände werden gemessen</translation>
    </message>
    <message>
        <source>mesh voxels</source>
        <translation>Voxel des Netzes</translation>
    </message>
    <message>
        <source>metering</source>
        <translation>Messung der Belichtung</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>motion target</source>
        <translation>Bildzeit bei Bewegung</translation>
    </message>
    <message>
        <source>near factor</source>
        <translation>Faktor nahe dem Isowert</translation>
    </message>
    <message>
        <source>near threshold</source>
        <translation>Schwelle nahe dem Isowert</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>uncertainty band</source>
        <translation>Band der Unsicherheit</translation>
    </message>
    <message>
        <source>normal scale</source>
        <translation>Skala der Normalen</translation>
    </message>
    <message>
        <source>only</source>
        <translation>Nur diese</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Dateipfad</translation>
    </message>
    <message>
        <source>planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>precision</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>wird vorbereitet</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>range high</source>
        <translation>Bereich bis</translation>
    </message>
    <message>
        <source>range low</source>
        <translation>Bereich von</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>Rohdaten</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>refinements</source>
        <translation>Verfeinerungen</translation>
    </message>
    <message>
        <source>hits at rest</source>
        <translation>Treffer in Ruhe</translation>
    </message>
    <message>
        <source>ridge colour</source>
        <translation>Farbe der Grate</translation>
    </message>
    <message>
        <source>ridge length</source>
        <translation>Länge der Grate</translation>
    </message>
    <message>
        <source>ridge threshold</source>
        <translation>Schwelle der Grate</translation>
    </message>
    <message>
        <source>ridge width</source>
        <translation>Breite der Grate</translation>
    </message>
    <message>
        <source>ridge width unit</source>
        <translation>Einheit der Breite</translation>
    </message>
    <message>
        <source>ridges</source>
        <translation>Grate und Täler</translation>
    </message>
    <message>
        <source>roulette depth</source>
        <translation>Roulette ab Reflexion</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Pfade</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>search</source>
        <translation>Suchstrecke</translation>
    </message>
    <message>
        <source>sequence</source>
        <translation>Zahlenfolge</translation>
    </message>
    <message>
        <source>series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>sh order</source>
        <translation>SH-Ordnung</translation>
    </message>
    <message>
        <source>sh window</source>
        <translation>SH-Fenster</translation>
    </message>
    <message>
        <source>shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>shininess</source>
        <translation>Glanzexponent</translation>
    </message>
    <message>
        <source>slab</source>
        <translation>Dicke der Schicht</translation>
    </message>
    <message>
        <source>slab mode</source>
        <translation>Projektion der dicken Schicht</translation>
    </message>
    <message>
        <source>minimum volume</source>
        <translation>Kleinstes Volumen</translation>
    </message>
    <message>
        <source>reference frame</source>
        <translation>Bezugssystem</translation>
    </message>
    <message>
        <source>specular</source>
        <translation>Glanzlicht</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>suggestive contours</source>
        <translation>Angedeutete Konturen</translation>
    </message>
    <message>
        <source>supersampling</source>
        <translation>Überabtastung</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>texels</source>
        <translation>Texel</translation>
    </message>
    <message>
        <source>texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>texture scale</source>
        <translation>Größe der Textur</translation>
    </message>
    <message>
        <source>threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>tone cool</source>
        <translation>Kalter Ton</translation>
    </message>
    <message>
        <source>tone warm</source>
        <translation>Warmer Ton</translation>
    </message>
    <message>
        <source>up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>valley colour</source>
        <translation>Farbe der Täler</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Fensterbreite</translation>
    </message>
    <message>
        <source>κ₁ (larger curvature)</source>
        <translation>κ₁ (größere Krümmung)</translation>
    </message>
    <message>
        <source>κ₁ and κ₂</source>
        <translation>κ₁ und κ₂</translation>
    </message>
    <message>
        <source>κ₂ (smaller curvature)</source>
        <translation>κ₂ (kleinere Krümmung)</translation>
    </message>
    <message>
        <source>View-dependent opacity</source>
        <translation>Deckkraft nach Blickrichtung</translation>
    </message>
    <message>
        <source>Isovalue</source>
        <translation>Isowert</translation>
    </message>
    <message>
        <source>Orientation labels</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>Looking for series</source>
        <translation>Serien werden gesucht</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Pixel ratio</source>
        <translation>Pixelverhältnis</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>view-dependent opacity</source>
        <translation>Deckkraft nach Blickrichtung</translation>
    </message>
    <message>
        <source>isovalue</source>
        <translation>Isowert</translation>
    </message>
    <message>
        <source>orientation labels</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>looking for series</source>
        <translation>Serien werden gesucht</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>pixel ratio</source>
        <translation>Pixelverhältnis</translation>
    </message>
    <message>
        <source>scale bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Bands of spherical harmonics</source>
        <translation>Bänder der Kugelfunktionen</translation>
    </message>
    <message>
        <source>Bits per component, on average</source>
        <translation>Bit je Komponente, im Mittel</translation>
    </message>
    <message>
        <source>Components of compressed transfer</source>
        <translation>Komponenten des komprimierten Transfers</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>Hit method</source>
        <translation>Treffermethode</translation>
    </message>
    <message>
        <source>Interpolation between texels</source>
        <translation>Interpolation zwischen Texeln</translation>
    </message>
    <message>
        <source>Near factor r1/r0</source>
        <translation>Nahfaktor r1/r0</translation>
    </message>
    <message>
        <source>Paths per texel</source>
        <translation>Pfade je Texel</translation>
    </message>
    <message>
        <source>Refinement steps</source>
        <translation>Verfeinerungsschritte</translation>
    </message>
    <message>
        <source>Texels per voxel and axis</source>
        <translation>Texel je Voxel und Achse</translation>
    </message>
    <message>
        <source>Where texels are lit</source>
        <translation>Wo Texel beleuchtet werden</translation>
    </message>
    <message>
        <source>Window of spherical harmonics</source>
        <translation>Fenster der Kugelfunktionen</translation>
    </message>
    <message>
        <source>Rays per pixel and axis</source>
        <translation>Strahlen je Pixel und Achse</translation>
    </message>
    <message>
        <source>Strength of the key light&apos;s shadow</source>
        <translation>Stärke des Schattens des Hauptlichts</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Indexing</source>
        <translation>Voxel werden erfasst</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Arbeitsspeicher</translation>
    </message>
    <message>
        <source>indexing</source>
        <translation>Voxel werden erfasst</translation>
    </message>
    <message>
        <source>Around damage</source>
        <translation>Unlesbare Blöcke überspringen</translation>
    </message>
    <message>
        <source>around damage</source>
        <translation>unlesbare Blöcke überspringen</translation>
    </message>
    <message>
        <source>Caveats</source>
        <translation>Vorbehalte</translation>
    </message>
    <message>
        <source>caveats</source>
        <translation>Vorbehalte</translation>
    </message>
    <message>
        <source>Framing</source>
        <translation>Bildausschnitt</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Suggestion</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>framing</source>
        <translation>Bildausschnitt</translation>
    </message>
    <message>
        <source>suggestion</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>within</source>
        <translation>Innerhalb</translation>
    </message>
    <message>
        <source>Fill light</source>
        <translation>Aufhelllicht</translation>
    </message>
    <message>
        <source>Key light only</source>
        <translation>Nur Hauptlicht</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>Occlusion radius</source>
        <translation>Reichweite der Verdeckung</translation>
    </message>
    <message>
        <source>Rim light</source>
        <translation>Kantenlicht</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>Three-point</source>
        <translation>Dreipunktlicht</translation>
    </message>
    <message>
        <source>CT in Hounsfield units</source>
        <translation>CT in Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>CT in other units</source>
        <translation>CT in anderen Einheiten</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Segmentierung (Labels)</translation>
    </message>
    <message>
        <source>MR</source>
        <translation>MR</translation>
    </message>
    <message>
        <source>Microscopy</source>
        <translation>Mikroskopie</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Entfernt</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>Fraction of directions from the environment</source>
        <translation>Anteil der Richtungen aus der Umgebung</translation>
    </message>
    <message>
        <source>Interpolant of derivatives</source>
        <translation>Interpolant der Ableitungen</translation>
    </message>
    <message>
        <source>Interpolant of hits</source>
        <translation>Interpolant der Treffer</translation>
    </message>
    <message>
        <source>Near threshold, multiples of automatic</source>
        <translation>Nahschwelle, Vielfaches der automatischen</translation>
    </message>
    <message>
        <source>Number format on the graphics card</source>
        <translation>Zahlenformat auf der Grafikkarte</translation>
    </message>
    <message>
        <source>Sampling rate, samples per voxel</source>
        <translation>Abtastrate, Abtastungen je Voxel</translation>
    </message>
    <message>
        <source>Scale σ, multiples of the mean spacing</source>
        <translation>Skala σ, Vielfaches des mittleren Voxelabstands</translation>
    </message>
    <message>
        <source>Voxel access of derivatives</source>
        <translation>Voxelzugriff der Ableitungen</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Texturen</translation>
    </message>
    <message>
        <source>canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>Accessibility points</source>
        <translation>Punkte der Zugänglichkeit</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überblendung</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Colourmap points</source>
        <translation>Punkte der Farbskala</translation>
    </message>
    <message>
        <source>Curvature direction</source>
        <translation>Krümmungsrichtung</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Tonwertkurve</translation>
    </message>
    <message>
        <source>Filmic</source>
        <translation>Filmisch</translation>
    </message>
    <message>
        <source>Flowline curvature</source>
        <translation>Flusslinienkrümmung</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Überlagerung</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Second weight</source>
        <translation>Gewicht des zweiten Volumens</translation>
    </message>
    <message>
        <source>accessibility points</source>
        <translation>Punkte der Zugänglichkeit</translation>
    </message>
    <message>
        <source>colormap points</source>
        <translation>Punkte der Farbskala</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Tonwertkurve</translation>
    </message>
    <message>
        <source>overlay</source>
        <translation>Überlagerung</translation>
    </message>
    <message>
        <source>roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>second weight</source>
        <translation>Gewicht des zweiten Volumens</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Dark studio</source>
        <translation>Dunkles Studio</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>environment shadows</source>
        <translation>Schatten der Umgebung</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Finding labels</source>
        <translation>Labels werden gesucht</translation>
    </message>
    <message>
        <source>Measuring labels</source>
        <translation>Labels werden gemessen</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>finding labels</source>
        <translation>Labels werden gesucht</translation>
    </message>
    <message>
        <source>labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>light angle</source>
        <translation>Lichtquelle: Winkel</translation>
    </message>
    <message>
        <source>light colour</source>
        <translation>Lichtquelle: Farbe</translation>
    </message>
    <message>
        <source>light direction</source>
        <translation>Lichtquelle: Richtung</translation>
    </message>
    <message>
        <source>light intensity</source>
        <translation>Lichtquelle: Helligkeit</translation>
    </message>
    <message>
        <source>light kind</source>
        <translation>Lichtquelle: Art</translation>
    </message>
    <message>
        <source>light name</source>
        <translation>Lichtquelle: Name</translation>
    </message>
    <message>
        <source>light position</source>
        <translation>Lichtquelle: Position</translation>
    </message>
    <message>
        <source>light radius</source>
        <translation>Lichtquelle: Radius</translation>
    </message>
    <message>
        <source>light shadows</source>
        <translation>Lichtquelle: Schatten</translation>
    </message>
    <message>
        <source>light shown</source>
        <translation>Lichtquelle: gezeigt</translation>
    </message>
    <message>
        <source>Label names</source>
        <translation>Namen der Labels</translation>
    </message>
    <message>
        <source>label names</source>
        <translation>Namen der Labels</translation>
    </message>
    <message>
        <source>measuring labels</source>
        <translation>Labels werden gemessen</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Label colors</source>
        <translation>Farben der Labels</translation>
    </message>
    <message>
        <source>label colours</source>
        <translation>Farben der Labels</translation>
    </message>
</context>
</TS>
