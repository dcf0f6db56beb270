<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Actions</name>
    <message>
        <source>Take the &amp;suggested plane</source>
        <translation>Vor&amp;geschlagene Ebene nehmen</translation>
    </message>
    <message>
        <source>Part the part where nothing stands in the way of the mold.</source>
        <translation>Das Teil dort teilen, wo der Form nichts im Weg steht.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open a part…</source>
        <translation>Teil &amp;öffnen …</translation>
    </message>
    <message>
        <source>Open a mesh (STL, OBJ, PLY, OFF) or a Moldwright project.</source>
        <translation>Ein Netz (STL, OBJ, PLY, OFF) oder ein Moldwright-Projekt öffnen.</translation>
    </message>
    <message>
        <source>&amp;Close the part</source>
        <translation>Teil s&amp;chließen</translation>
    </message>
    <message>
        <source>Close the part and go back to the start page.</source>
        <translation>Das Teil schließen und zur Startseite zurückkehren.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the project to its file.</source>
        <translation>Das Projekt in seine Datei speichern.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the project to another file.</source>
        <translation>Das Projekt in eine andere Datei speichern.</translation>
    </message>
    <message>
        <source>&amp;Export the shape…</source>
        <translation>&amp;Form exportieren …</translation>
    </message>
    <message>
        <source>Write the shape in view as STL, PLY, OBJ or OFF.</source>
        <translation>Die gezeigte Form als STL, PLY, OBJ oder OFF schreiben.</translation>
    </message>
    <message>
        <source>Export the &amp;halves…</source>
        <translation>&amp;Hälften exportieren …</translation>
    </message>
    <message>
        <source>Write both mold halves into a folder.</source>
        <translation>Beide Formhälften in einen Ordner schreiben.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close Moldwright.</source>
        <translation>Moldwright schließen.</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last edit back.</source>
        <translation>Die letzte Änderung zurücknehmen.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Do the edit again.</source>
        <translation>Die Änderung wiederholen.</translation>
    </message>
    <message>
        <source>&amp;Find a command</source>
        <translation>Befehl &amp;suchen</translation>
    </message>
    <message>
        <source>Find any command by its words.</source>
        <translation>Jeden Befehl anhand seiner Wörter finden.</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Fit all</source>
        <translation>Alles &amp;einpassen</translation>
    </message>
    <message>
        <source>Bring everything into sight.</source>
        <translation>Alles ins Bild holen.</translation>
    </message>
    <message>
        <source>&amp;Home view</source>
        <translation>&amp;Grundansicht</translation>
    </message>
    <message>
        <source>Look from the front, right and above.</source>
        <translation>Von vorn, rechts und oben sehen.</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Look from the front.</source>
        <translation>Von vorn sehen.</translation>
    </message>
    <message>
        <source>R&amp;ight</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>Look from the right.</source>
        <translation>Von rechts sehen.</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Look from above.</source>
        <translation>Von oben sehen.</translation>
    </message>
    <message>
        <source>Opp&amp;osite</source>
        <translation>Ge&amp;genseite</translation>
    </message>
    <message>
        <source>Look from the other side.</source>
        <translation>Von der anderen Seite sehen.</translation>
    </message>
    <message>
        <source>At the parting plane</source>
        <translation>Auf die Trennebene</translation>
    </message>
    <message>
        <source>Look along the normal of the parting plane.</source>
        <translation>Entlang der Normalen der Trennebene sehen.</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>Show depth as the eye sees it, or without.</source>
        <translation>Tiefe zeigen, wie das Auge sie sieht, oder ohne.</translation>
    </message>
    <message>
        <source>&amp;Undercuts</source>
        <translation>&amp;Hinterschnitte</translation>
    </message>
    <message>
        <source>Paint the faces below the required draft red.</source>
        <translation>Flächen unter der verlangten Schräge rot zeigen.</translation>
    </message>
    <message>
        <source>&amp;Draft map</source>
        <translation>&amp;Schrägenkarte</translation>
    </message>
    <message>
        <source>Paint every face by its draft angle.</source>
        <translation>Jede Fläche nach ihrer Entformungsschräge färben.</translation>
    </message>
    <message>
        <source>P&amp;lain</source>
        <translation>S&amp;chlicht</translation>
    </message>
    <message>
        <source>Show the shape alone.</source>
        <translation>Nur die Form zeigen.</translation>
    </message>
    <message>
        <source>Parting plane</source>
        <translation>Trennebene</translation>
    </message>
    <message>
        <source>Show or hide the parting plane.</source>
        <translation>Die Trennebene zeigen oder verbergen.</translation>
    </message>
    <message>
        <source>Removal directions</source>
        <translation>Entformungsrichtungen</translation>
    </message>
    <message>
        <source>Show or hide both removal directions.</source>
        <translation>Beide Entformungsrichtungen zeigen oder verbergen.</translation>
    </message>
    <message>
        <source>Mesh edges</source>
        <translation>Netzkanten</translation>
    </message>
    <message>
        <source>Show or hide the edges of the faces.</source>
        <translation>Die Kanten der Flächen zeigen oder verbergen.</translation>
    </message>
    <message>
        <source>See-through</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Show the shape as if it were glass.</source>
        <translation>Die Form zeigen, als wäre sie aus Glas.</translation>
    </message>
    <message>
        <source>Save a picture…</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Write the view as a PNG picture.</source>
        <translation>Die Ansicht als PNG-Bild schreiben.</translation>
    </message>
    <message>
        <source>&amp;Part</source>
        <translation>&amp;Teil</translation>
    </message>
    <message>
        <source>&amp;Lay flat on a face</source>
        <translation>Auf eine Fläche &amp;legen</translation>
    </message>
    <message>
        <source>Click the face that shall lie on the ground. Esc leaves.</source>
        <translation>Die Fläche anklicken, die auf dem Boden liegen soll. Esc beendet.</translation>
    </message>
    <message>
        <source>Turn about &amp;X</source>
        <translation>Um &amp;X drehen</translation>
    </message>
    <message>
        <source>Turn the part by 90° about the x axis.</source>
        <translation>Das Teil um 90° um die x-Achse drehen.</translation>
    </message>
    <message>
        <source>Turn about &amp;Y</source>
        <translation>Um &amp;Y drehen</translation>
    </message>
    <message>
        <source>Turn the part by 90° about the y axis.</source>
        <translation>Das Teil um 90° um die y-Achse drehen.</translation>
    </message>
    <message>
        <source>Turn about &amp;Z</source>
        <translation>Um &amp;Z drehen</translation>
    </message>
    <message>
        <source>Turn the part by 90° about the z axis.</source>
        <translation>Das Teil um 90° um die z-Achse drehen.</translation>
    </message>
    <message>
        <source>Move to the &amp;middle</source>
        <translation>In die &amp;Mitte rücken</translation>
    </message>
    <message>
        <source>Put the middle of the part above the origin, on the ground.</source>
        <translation>Die Mitte des Teils über den Ursprung stellen, auf den Boden.</translation>
    </message>
    <message>
        <source>P&amp;lane</source>
        <translation>&amp;Ebene</translation>
    </message>
    <message>
        <source>&amp;Best plane</source>
        <translation>&amp;Beste Ebene</translation>
    </message>
    <message>
        <source>Search all planes for the one that leaves the least to deform.</source>
        <translation>Unter allen Ebenen die suchen, bei der am wenigsten zu verformen bleibt.</translation>
    </message>
    <message>
        <source>&amp;Next best plane</source>
        <translation>&amp;Nächstbeste Ebene</translation>
    </message>
    <message>
        <source>Take the next plane of the last search.</source>
        <translation>Die nächste Ebene der letzten Suche nehmen.</translation>
    </message>
    <message>
        <source>Best &amp;directions</source>
        <translation>Beste &amp;Richtungen</translation>
    </message>
    <message>
        <source>Tilt both directions to where the least is left to deform.</source>
        <translation>Beide Richtungen dorthin neigen, wo am wenigsten zu verformen bleibt.</translation>
    </message>
    <message>
        <source>Directions along the &amp;normal</source>
        <translation>Richtungen entlang der N&amp;ormalen</translation>
    </message>
    <message>
        <source>Let both halves leave straight along the plane&apos;s normal.</source>
        <translation>Beide Hälften gerade entlang der Ebenennormalen abziehen.</translation>
    </message>
    <message>
        <source>&amp;Deform</source>
        <translation>&amp;Verformen</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>Bend the part until it leaves the mold, and prove it.</source>
        <translation>Das Teil biegen, bis es sich entformen lässt, und dies beweisen.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Halt</translation>
    </message>
    <message>
        <source>Restore original shape</source>
        <translation>Ursprüngliche Form</translation>
    </message>
    <message>
        <source>Back to the undeformed part; the plane stays.</source>
        <translation>Zurück zum unverformten Teil; die Ebene bleibt.</translation>
    </message>
    <message>
        <source>&amp;Mold</source>
        <translation>&amp;Form</translation>
    </message>
    <message>
        <source>&amp;Build mold</source>
        <translation>Form &amp;bauen</translation>
    </message>
    <message>
        <source>Make both mold halves around the cast, and prove that they come off.</source>
        <translation>Beide Formhälften um den Guss bauen und beweisen, dass sie sich abziehen lassen.</translation>
    </message>
    <message>
        <source>&amp;Open or close the mold</source>
        <translation>Form &amp;öffnen oder schließen</translation>
    </message>
    <message>
        <source>Move the halves apart along their directions, or together.</source>
        <translation>Die Hälften entlang ihrer Richtungen auseinander- oder zusammenfahren.</translation>
    </message>
    <message>
        <source>&amp;Report</source>
        <translation>&amp;Bericht</translation>
    </message>
    <message>
        <source>&amp;Print report…</source>
        <translation>Bericht &amp;drucken …</translation>
    </message>
    <message>
        <source>Make a PDF with pictures, draft, volumes and the proof.</source>
        <translation>Ein PDF mit Bildern, Schräge, Volumen und dem Beweis machen.</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Use the light theme.</source>
        <translation>Helle Farben verwenden.</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Use the dark theme.</source>
        <translation>Dunkle Farben verwenden.</translation>
    </message>
    <message>
        <source>Like the desk&amp;top</source>
        <translation>Wie der &amp;Schreibtisch</translation>
    </message>
    <message>
        <source>Follow the desktop&apos;s colours.</source>
        <translation>Den Farben des Schreibtischs folgen.</translation>
    </message>
    <message>
        <source>Next area</source>
        <translation>Nächster Bereich</translation>
    </message>
    <message>
        <source>Move the keyboard to the next area of the window.</source>
        <translation>Die Tastatur in den nächsten Bereich des Fensters bringen.</translation>
    </message>
    <message>
        <source>Previous area</source>
        <translation>Voriger Bereich</translation>
    </message>
    <message>
        <source>Move the keyboard to the previous area of the window.</source>
        <translation>Die Tastatur in den vorigen Bereich des Fensters bringen.</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Put all panels back where they were at first.</source>
        <translation>Alle Felder dorthin stellen, wo sie anfangs waren.</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>Show all keys on one sheet.</source>
        <translation>Alle Tasten auf einem Blatt zeigen.</translation>
    </message>
    <message>
        <source>&amp;About Moldwright</source>
        <translation>&amp;Über Moldwright</translation>
    </message>
    <message>
        <source>Version, licence, libraries.</source>
        <translation>Version, Lizenz, Bibliotheken.</translation>
    </message>
    <message>
        <source>Tu&amp;rn by an angle…</source>
        <translation>Um einen &amp;Winkel drehen…</translation>
    </message>
    <message>
        <source>Turn the part about an axis, by any angle.</source>
        <translation>Das Teil um eine Achse drehen, um jeden Winkel.</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Fertigstellen</translation>
    </message>
    <message>
        <source>Bend no further: finish the shape from where it is, and prove it.</source>
        <translation>Nicht weiter biegen: die Form von hier aus fertigstellen und beweisen.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Hold the shape where it is, or bend it further.</source>
        <translation>Die Form festhalten, wo sie ist, oder weiter biegen.</translation>
    </message>
    <message>
        <source>Fi&amp;ll and run</source>
        <translation>Füllen und s&amp;tarten</translation>
    </message>
    <message>
        <source>Run, and fill the places that no bending frees.</source>
        <translation>Starten und füllen, was kein Biegen frei macht.</translation>
    </message>
    <message>
        <source>End the run; the shape it reached is kept.</source>
        <translation>Den Lauf beenden; die erreichte Gestalt bleibt.</translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation>&amp;Eine Ansicht</translation>
    </message>
    <message>
        <source>Show one view.</source>
        <translation>Eine Ansicht zeigen.</translation>
    </message>
    <message>
        <source>T&amp;wo views</source>
        <translation>&amp;Zwei Ansichten</translation>
    </message>
    <message>
        <source>Show the part and its cast beside each other.</source>
        <translation>Das Teil und seinen Guss nebeneinander zeigen.</translation>
    </message>
    <message>
        <source>Fo&amp;ur views</source>
        <translation>&amp;Vier Ansichten</translation>
    </message>
    <message>
        <source>Show it from above, from the front, from the right, and freely.</source>
        <translation>Von oben, von vorn, von rechts und frei zeigen.</translation>
    </message>
    <message>
        <source>Lin&amp;k the views</source>
        <translation>Ansichten &amp;koppeln</translation>
    </message>
    <message>
        <source>Let all views move together.</source>
        <translation>Alle Ansichten bewegen sich gemeinsam.</translation>
    </message>
    <message>
        <source>Undercut d&amp;epth</source>
        <translation>&amp;Tiefe der Hinterschnitte</translation>
    </message>
    <message>
        <source>Paint every undercut by how far it is blocked, in mm.</source>
        <translation>Jeden Hinterschnitt danach färben, wie weit er versperrt ist, in mm.</translation>
    </message>
    <message>
        <source>De&amp;viation</source>
        <translation>Ab&amp;weichung</translation>
    </message>
    <message>
        <source>Paint how far cast and part are apart, in mm.</source>
        <translation>Färben, wie weit Guss und Teil auseinanderliegen, in mm.</translation>
    </message>
    <message>
        <source>&amp;Strain</source>
        <translation>&amp;Dehnung</translation>
    </message>
    <message>
        <source>Paint how much the surface was stretched, in percent.</source>
        <translation>Färben, wie stark die Oberfläche gedehnt wurde, in Prozent.</translation>
    </message>
    <message>
        <source>Se&amp;ction</source>
        <translation>S&amp;chnitt</translation>
    </message>
    <message>
        <source>Cut the view open at the parting plane, or anywhere along it.</source>
        <translation>Die Ansicht an der Trennebene oder irgendwo daneben aufschneiden.</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Click places on the surface: draft, thickness, distance, angle. Esc leaves.</source>
        <translation>Stellen auf der Oberfläche anklicken: Schräge, Dicke, Abstand, Winkel. Esc beendet.</translation>
    </message>
    <message>
        <source>&amp;Copy what was measured</source>
        <translation>Gemessenes &amp;kopieren</translation>
    </message>
    <message>
        <source>Put the measured values on the clipboard, as text.</source>
        <translation>Die Messwerte als Text in die Zwischenablage legen.</translation>
    </message>
    <message>
        <source>Save a t&amp;urntable…</source>
        <translation>&amp;Rundumansicht speichern …</translation>
    </message>
    <message>
        <source>Turn the view once around and write an animated PNG. Esc stops.</source>
        <translation>Die Ansicht einmal herumdrehen und als animiertes PNG schreiben. Esc hält an.</translation>
    </message>
    <message>
        <source>Find &amp;undercuts</source>
        <translation>Hinterschnitte &amp;suchen</translation>
    </message>
    <message>
        <source>List the undercuts at this plane, to have each one bent or filled.</source>
        <translation>Die Hinterschnitte an dieser Ebene aufführen, um jeden zu biegen oder zu füllen.</translation>
    </message>
    <message>
        <source>Fill or &amp;join here</source>
        <translation>Hier füllen oder &amp;verbinden</translation>
    </message>
    <message>
        <source>Have what the chosen obstruction spans filled; Run bends the rest.</source>
        <translation>Was das gewählte Hindernis überspannt, füllen lassen; Start biegt den Rest.</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Theme, language, mouse, defaults and keys.</source>
        <translation>Farben, Sprache, Maus, Vorgaben und Tasten.</translation>
    </message>
    <message>
        <source>Square to &amp;X</source>
        <translation>Quer zu &amp;X</translation>
    </message>
    <message>
        <source>Turn the plane square to the x axis; it stays where it is in the part.</source>
        <translation>Die Ebene quer zur X-Achse drehen; sie bleibt, wo sie im Teil ist.</translation>
    </message>
    <message>
        <source>Square to &amp;Y</source>
        <translation>Quer zu &amp;Y</translation>
    </message>
    <message>
        <source>Turn the plane square to the y axis; it stays where it is in the part.</source>
        <translation>Die Ebene quer zur Y-Achse drehen; sie bleibt, wo sie im Teil ist.</translation>
    </message>
    <message>
        <source>Square to &amp;Z</source>
        <translation>Quer zu &amp;Z</translation>
    </message>
    <message>
        <source>Turn the plane square to the z axis; it stays where it is in the part.</source>
        <translation>Die Ebene quer zur Z-Achse drehen; sie bleibt, wo sie im Teil ist.</translation>
    </message>
    <message>
        <source>Through three &amp;points</source>
        <translation>Durch drei &amp;Punkte</translation>
    </message>
    <message>
        <source>Click three places that the plane shall run through. Esc leaves.</source>
        <translation>Drei Stellen anklicken, durch die die Ebene gehen soll. Esc beendet.</translation>
    </message>
    <message>
        <source>On a &amp;face</source>
        <translation>Auf eine &amp;Fläche</translation>
    </message>
    <message>
        <source>Click the face that the plane shall lie in. Esc leaves.</source>
        <translation>Die Fläche anklicken, in der die Ebene liegen soll. Esc beendet.</translation>
    </message>
    <message>
        <source>&amp;Guides</source>
        <translation>&amp;Führung</translation>
    </message>
    <message>
        <source>&amp;Pin a point</source>
        <translation>&amp;Punkt anheften</translation>
    </message>
    <message>
        <source>Click points of the part that shall lie on the parting plane. Esc leaves.</source>
        <translation>Punkte des Teils anklicken, die auf der Trennebene liegen sollen. Esc beendet.</translation>
    </message>
    <message>
        <source>Pin a point &amp;inside</source>
        <translation>Punkt &amp;innen anheften</translation>
    </message>
    <message>
        <source>Click to pin the point farthest inside below the pointer. Esc leaves.</source>
        <translation>Klicken heftet den Punkt an, der unter dem Zeiger am tiefsten innen liegt. Esc beendet.</translation>
    </message>
    <message>
        <source>&amp;Suggest pins</source>
        <translation>Heftpunkte &amp;vorschlagen</translation>
    </message>
    <message>
        <source>Look for points worth pinning: ends of limbs, where limbs meet, along the body.</source>
        <translation>Punkte suchen, die das Anheften lohnen: Enden von Gliedern, wo Glieder sich treffen, längs des Körpers.</translation>
    </message>
    <message>
        <source>Accept &amp;tips</source>
        <translation>&amp;Enden annehmen</translation>
    </message>
    <message>
        <source>Pin all suggested points that are ends of limbs.</source>
        <translation>Alle vorgeschlagenen Punkte anheften, die Enden von Gliedern sind.</translation>
    </message>
    <message>
        <source>Remove &amp;all pins</source>
        <translation>&amp;Alle Heftpunkte entfernen</translation>
    </message>
    <message>
        <source>Remove all pins; the suggested ones stay.</source>
        <translation>Alle Heftpunkte entfernen; die vorgeschlagenen bleiben.</translation>
    </message>
    <message>
        <source>Pins from a &amp;file…</source>
        <translation>Heftpunkte aus &amp;Datei…</translation>
    </message>
    <message>
        <source>Read pins from a JSON file, as the command line takes it.</source>
        <translation>Heftpunkte aus einer JSON-Datei lesen, wie die Befehlszeile sie nimmt.</translation>
    </message>
    <message>
        <source>Pins &amp;into a file…</source>
        <translation>Heftpunkte &amp;in Datei…</translation>
    </message>
    <message>
        <source>Write all pins as JSON for the command line or another project.</source>
        <translation>Alle Heftpunkte als JSON schreiben, für die Befehlszeile oder ein anderes Projekt.</translation>
    </message>
    <message>
        <source>Go to Part</source>
        <translation>Zu Teil</translation>
    </message>
    <message>
        <source>Go to the step Part.</source>
        <translation>Zum Schritt Teil gehen.</translation>
    </message>
    <message>
        <source>Go to Plane</source>
        <translation>Zu Ebene</translation>
    </message>
    <message>
        <source>Go to the step Plane.</source>
        <translation>Zum Schritt Ebene gehen.</translation>
    </message>
    <message>
        <source>Go to Guides</source>
        <translation>Zu Führung</translation>
    </message>
    <message>
        <source>Go to the step Guides.</source>
        <translation>Zum Schritt Führung gehen.</translation>
    </message>
    <message>
        <source>Go to Deform</source>
        <translation>Zu Verformen</translation>
    </message>
    <message>
        <source>Go to the step Deform.</source>
        <translation>Zum Schritt Verformen gehen.</translation>
    </message>
    <message>
        <source>Go to Check</source>
        <translation>Zu Prüfen</translation>
    </message>
    <message>
        <source>Go to the step Check.</source>
        <translation>Zum Schritt Prüfen gehen.</translation>
    </message>
    <message>
        <source>Go to Mold</source>
        <translation>Zu Form</translation>
    </message>
    <message>
        <source>Go to the step Mold.</source>
        <translation>Zum Schritt Form gehen.</translation>
    </message>
    <message>
        <source>Go to Report</source>
        <translation>Zu Bericht</translation>
    </message>
    <message>
        <source>Go to the step Report.</source>
        <translation>Zum Schritt Bericht gehen.</translation>
    </message>
    <message>
        <source>Take the &amp;tour</source>
        <translation>&amp;Rundgang machen</translation>
    </message>
    <message>
        <source>Five steps from a part to its mold, at your own pace.</source>
        <translation>Fünf Schritte vom Teil zu seiner Form, so schnell Sie mögen.</translation>
    </message>
    <message>
        <source>&amp;Importance</source>
        <translation>&amp;Wichtigkeit</translation>
    </message>
    <message>
        <source>Paint every face by how important it is to keep its shape.</source>
        <translation>Jede Fläche danach färben, wie wichtig es ist, dass sie ihre Form behält.</translation>
    </message>
    <message>
        <source>&amp;Remove what is chosen</source>
        <translation>Gewähltes &amp;entfernen</translation>
    </message>
    <message>
        <source>P&amp;aint importance</source>
        <translation>Wichtigkeit &amp;malen</translation>
    </message>
    <message>
        <source>Draw over what is to keep its shape: each stroke doubles its weight. Esc leaves.</source>
        <translation>Darüber malen, was seine Form behalten soll: Jeder Strich verdoppelt das Gewicht. Esc beendet.</translation>
    </message>
    <message>
        <source>Paint up to &amp;creases</source>
        <translation>Bis zu &amp;Kanten malen</translation>
    </message>
    <message>
        <source>Click a face: the stroke goes as far as the surface is smooth. Esc leaves.</source>
        <translation>Eine Fläche anklicken: Der Strich reicht so weit, wie die Oberfläche glatt ist. Esc beendet.</translation>
    </message>
    <message>
        <source>Paint a whole p&amp;iece</source>
        <translation>Ein ganzes &amp;Stück malen</translation>
    </message>
    <message>
        <source>Click a face: the stroke takes all that is connected with it. Esc leaves.</source>
        <translation>Eine Fläche anklicken: Der Strich nimmt alles, was mit ihr zusammenhängt. Esc beendet.</translation>
    </message>
    <message>
        <source>Paint in a &amp;lasso</source>
        <translation>In einem &amp;Lasso malen</translation>
    </message>
    <message>
        <source>Draw around what is to be painted: faces that are seen inside. Esc leaves.</source>
        <translation>Um das herumfahren, was gemalt werden soll: Flächen, die man darin sieht. Esc beendet.</translation>
    </message>
    <message>
        <source>&amp;Erase</source>
        <translation>&amp;Radieren</translation>
    </message>
    <message>
        <source>Let strokes halve weights instead of doubling them; Ctrl does the opposite.</source>
        <translation>Striche halbieren Gewichte, statt sie zu verdoppeln; mit Strg umgekehrt.</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>&amp;Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>Make the brush smaller. Alt and the wheel do so too.</source>
        <translation>Den Pinsel verkleinern. Alt und das Mausrad tun es auch.</translation>
    </message>
    <message>
        <source>Lar&amp;ger brush</source>
        <translation>&amp;Größerer Pinsel</translation>
    </message>
    <message>
        <source>Make the brush larger. Alt and the wheel do so too.</source>
        <translation>Den Pinsel vergrößern. Alt und das Mausrad tun es auch.</translation>
    </message>
    <message>
        <source>&amp;New region</source>
        <translation>&amp;Neue Region</translation>
    </message>
    <message>
        <source>Let the next stroke make a region of its own.</source>
        <translation>Der nächste Strich bildet eine eigene Region.</translation>
    </message>
    <message>
        <source>Remove all re&amp;gions</source>
        <translation>Alle Re&amp;gionen entfernen</translation>
    </message>
    <message>
        <source>Nothing is more important than the rest then.</source>
        <translation>Dann ist nichts wichtiger als der Rest.</translation>
    </message>
    <message>
        <source>Regions from a file…</source>
        <translation>Regionen aus Datei…</translation>
    </message>
    <message>
        <source>Read important regions from a JSON file, as the command line takes it.</source>
        <translation>Wichtige Regionen aus einer JSON-Datei lesen, wie die Befehlszeile sie nimmt.</translation>
    </message>
    <message>
        <source>Regions into a file…</source>
        <translation>Regionen in Datei…</translation>
    </message>
    <message>
        <source>Write all regions as JSON for the command line or another project.</source>
        <translation>Alle Regionen als JSON für die Befehlszeile oder ein anderes Projekt schreiben.</translation>
    </message>
    <message>
        <source>One s&amp;tep</source>
        <translation>Ein S&amp;chritt</translation>
    </message>
    <message>
        <source>Bend a paused shape by one step.</source>
        <translation>Eine ruhende Form um einen Schritt weiter biegen.</translation>
    </message>
    <message>
        <source>&amp;Earlier frame</source>
        <translation>&amp;Früheres Bild</translation>
    </message>
    <message>
        <source>Look at the frame before; a run pauses.</source>
        <translation>Das Bild davor ansehen; ein Lauf ruht dabei.</translation>
    </message>
    <message>
        <source>&amp;Later frame</source>
        <translation>&amp;Späteres Bild</translation>
    </message>
    <message>
        <source>Look at the frame after.</source>
        <translation>Das Bild danach ansehen.</translation>
    </message>
    <message>
        <source>Go on from &amp;here</source>
        <translation>Von &amp;hier weiter</translation>
    </message>
    <message>
        <source>Run anew from the shape, plane and settings of the frame in view.</source>
        <translation>Neu laufen, von Form, Ebene und Vorgaben des gezeigten Bildes aus.</translation>
    </message>
    <message>
        <source>&amp;New variant</source>
        <translation>&amp;Neue Variante</translation>
    </message>
    <message>
        <source>Begin another design of this part, without pins and regions.</source>
        <translation>Einen weiteren Entwurf dieses Teils beginnen, ohne Heftpunkte und Regionen.</translation>
    </message>
    <message>
        <source>&amp;Duplicate the variant</source>
        <translation>Variante &amp;duplizieren</translation>
    </message>
    <message>
        <source>Work on a copy of this design; the other stays as it is.</source>
        <translation>An einer Kopie dieses Entwurfs arbeiten; der andere bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Make &amp;current</source>
        <translation>Zur a&amp;ktuellen machen</translation>
    </message>
    <message>
        <source>Go on with the variant that is chosen.</source>
        <translation>Mit der gewählten Variante weiterarbeiten.</translation>
    </message>
    <message>
        <source>Next &amp;variant</source>
        <translation>Nächste &amp;Variante</translation>
    </message>
    <message>
        <source>Go on with the next variant of this part.</source>
        <translation>Mit der nächsten Variante dieses Teils weiterarbeiten.</translation>
    </message>
    <message>
        <source>Previous v&amp;ariant</source>
        <translation>Vorige V&amp;ariante</translation>
    </message>
    <message>
        <source>Go on with the variant before this one.</source>
        <translation>Mit der Variante vor dieser weiterarbeiten.</translation>
    </message>
    <message>
        <source>C&amp;ompare</source>
        <translation>Ver&amp;gleichen</translation>
    </message>
    <message>
        <source>Show another variant beside the current one, and how far their casts are apart.</source>
        <translation>Eine andere Variante neben der aktuellen zeigen, und wie weit ihre Güsse auseinander liegen.</translation>
    </message>
    <message>
        <source>R&amp;ename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Differe&amp;nce</source>
        <translation>Unters&amp;chied</translation>
    </message>
    <message>
        <source>Paint how far the casts of two compared variants are apart, in mm.</source>
        <translation>Zeigen, wie weit die Güsse zweier verglichener Varianten auseinander liegen, in mm.</translation>
    </message>
    <message>
        <source>Place &amp;automatically</source>
        <translation>&amp;Automatisch platzieren</translation>
    </message>
    <message>
        <source>Give the chosen feature of the mold back to the program.</source>
        <translation>Das gewählte Element der Form wieder dem Programm überlassen.</translation>
    </message>
    <message>
        <source>Place a&amp;ll automatically</source>
        <translation>A&amp;lle automatisch platzieren</translation>
    </message>
    <message>
        <source>Give all features of the mold back that a hand has placed.</source>
        <translation>Alle von Hand gesetzten Elemente der Form wieder dem Programm überlassen.</translation>
    </message>
    <message>
        <source>Accept in a lass&amp;o</source>
        <translation>In einem Lass&amp;o annehmen</translation>
    </message>
    <message>
        <source>Draw around suggested points: all inside are pinned. Esc leaves.</source>
        <translation>Um vorgeschlagene Punkte herum zeichnen: Alle darin werden angeheftet. Esc beendet.</translation>
    </message>
    <message>
        <source>&amp;Save as a preset…</source>
        <translation>Als Vorgabe &amp;speichern …</translation>
    </message>
    <message>
        <source>Keep block, layout, features and machines under a name, for other parts.</source>
        <translation>Block, Anordnung, Merkmale und Maschinen unter einem Namen aufheben, für andere Teile.</translation>
    </message>
    <message>
        <source>&amp;Remove the preset</source>
        <translation>Vorgabe &amp;entfernen</translation>
    </message>
    <message>
        <source>Forget it; the mold keeps its settings.</source>
        <translation>Sie vergessen; die Form behält ihre Einstellungen.</translation>
    </message>
    <message>
        <source>Re&amp;cover lost work</source>
        <translation>&amp;Verlorene Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>Open what was not saved last time.</source>
        <translation>Öffnen, was beim letzten Mal nicht gespeichert war.</translation>
    </message>
    <message>
        <source>Give what is chosen another name.</source>
        <translation>Dem Gewählten einen anderen Namen geben.</translation>
    </message>
    <message>
        <source>&amp;Show or hide</source>
        <translation>Zeigen oder &amp;verbergen</translation>
    </message>
    <message>
        <source>Show or hide what is chosen.</source>
        <translation>Das Gewählte zeigen oder verbergen.</translation>
    </message>
    <message>
        <source>Fit what is &amp;chosen</source>
        <translation>&amp;Gewähltes einpassen</translation>
    </message>
    <message>
        <source>Bring what is chosen in the project into sight; else everything.</source>
        <translation>Bringt ins Bild, was im Projekt gewählt ist, sonst alles.</translation>
    </message>
    <message>
        <source>S&amp;teel</source>
        <translation>S&amp;tahl</translation>
    </message>
    <message>
        <source>Paint the walls of the mold by the steel behind them, in mm.</source>
        <translation>Die Wände der Form nach dem Stahl dahinter einfärben, in mm.</translation>
    </message>
    <message>
        <source>Read the file &amp;again</source>
        <translation>Datei noch einmal l&amp;esen</translation>
    </message>
    <message>
        <source>Read the mesh that cannot be used once more, after it was mended in the program that made it.</source>
        <translation>Das unbrauchbare Netz noch einmal lesen, nachdem es in seinem Programm ausgebessert wurde.</translation>
    </message>
    <message>
        <source>&amp;Back to what was open</source>
        <translation>&amp;Zurück zum Geöffneten</translation>
    </message>
    <message>
        <source>Leave the mesh that cannot be used; what was open before comes back. Esc does so too.</source>
        <translation>Das unbrauchbare Netz verlassen; was vorher offen war, kommt zurück. Esc tut das auch.</translation>
    </message>
    <message>
        <source>Copy the &amp;diagnosis</source>
        <translation>&amp;Befund kopieren</translation>
    </message>
    <message>
        <source>Put all that is wrong with the mesh on the clipboard, as text.</source>
        <translation>Alles, was am Netz falsch ist, als Text in die Zwischenablage legen.</translation>
    </message>
    <message>
        <source>Show the ne&amp;xt place</source>
        <translation>Nä&amp;chste Stelle zeigen</translation>
    </message>
    <message>
        <source>Bring the next place where the mesh cannot be used into sight.</source>
        <translation>Die nächste Stelle ins Bild bringen, an der das Netz unbrauchbar ist.</translation>
    </message>
    <message>
        <source>Re&amp;pair the mesh</source>
        <translation>Netz re&amp;parieren</translation>
    </message>
    <message>
        <source>Mend what is wrong with the mesh, or make a closed skin about it, and open that. The file stays as it is.</source>
        <translation>Behebt, was am Netz nicht stimmt, oder legt eine geschlossene Haut darum, und öffnet das. Die Datei bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>&amp;Materials…</source>
        <translation>&amp;Materialien…</translation>
    </message>
    <message>
        <source>Look at what materials ask for, change them, add your own.</source>
        <translation>Ansehen, was Materialien verlangen, sie ändern, eigene anlegen.</translation>
    </message>
    <message>
        <source>&amp;Design with its draft</source>
        <translation>Mit &amp;dessen Schräge entwerfen</translation>
    </message>
    <message>
        <source>Ask for the draft that is usual for the chosen material; the cast is to be designed anew.</source>
        <translation>Die für das gewählte Material übliche Schräge verlangen; der Guss ist neu zu entwerfen.</translation>
    </message>
    <message>
        <source>Remove the pin, the region, the variant or the part of the mold that is chosen.</source>
        <translation>Den gewählten Heftpunkt, die Region, die Variante oder das Teil der Form entfernen.</translation>
    </message>
    <message>
        <source>Add a &amp;part to the mold…</source>
        <translation>Teil in die Form auf&amp;nehmen …</translation>
    </message>
    <message>
        <source>Give the mold cavities of other finished casts, from their project files.</source>
        <translation>Der Form Kavitäten anderer fertiger Güsse geben, aus ihren Projektdateien.</translation>
    </message>
    <message>
        <source>Read the part a&amp;gain</source>
        <translation>Teil erne&amp;ut lesen</translation>
    </message>
    <message>
        <source>Take the chosen part of the mold from its project file as it is now.</source>
        <translation>Das gewählte Teil der Form aus seiner Projektdatei nehmen, wie sie jetzt ist.</translation>
    </message>
</context>
<context>
    <name>DisplayMode</name>
    <message>
        <source>Undercuts</source>
        <translation>Hinterschnitte</translation>
    </message>
    <message>
        <source>Draft map</source>
        <translation>Schrägenkarte</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Schlicht</translation>
    </message>
    <message>
        <source>Undercut depth</source>
        <translation>Tiefe der Hinterschnitte</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Wichtigkeit</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Stahl</translation>
    </message>
</context>
<context>
    <name>FacePaint</name>
    <message>
        <source>Draft below %1</source>
        <translation>Schräge unter %1</translation>
    </message>
    <message>
        <source>Draft %1 or more</source>
        <translation>Schräge %1 oder mehr</translation>
    </message>
    <message>
        <source>Undercuts</source>
        <translation>Hinterschnitte</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Schräge</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>mm, after best fit</source>
        <translation>mm, nach bester Einpassung</translation>
    </message>
    <message>
        <source>%, both stretches together</source>
        <translation>%, beide Dehnungen zusammen</translation>
    </message>
    <message>
        <source>mm along the removal direction</source>
        <translation>mm in Entformungsrichtung</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>Shown once the run has ended.</source>
        <translation>Erscheint, wenn der Lauf beendet ist.</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Wird gemessen</translation>
    </message>
    <message>
        <source>Needs a parting plane.</source>
        <translation>Braucht eine Trennebene.</translation>
    </message>
    <message>
        <source>Needs a cast: Run makes one.</source>
        <translation>Braucht einen Guss: Ein Lauf erzeugt ihn.</translation>
    </message>
    <message>
        <source>The file is of an older version: run again.</source>
        <translation>Die Datei ist von einer älteren Version: neu laufen lassen.</translation>
    </message>
    <message>
        <source>Shown on the cast only.</source>
        <translation>Nur auf dem Guss zu sehen.</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>No undercut</source>
        <translation>Kein Hinterschnitt</translation>
    </message>
    <message>
        <source>mm between both casts</source>
        <translation>mm zwischen beiden Güssen</translation>
    </message>
    <message>
        <source>Needs another variant: Compare shows one.</source>
        <translation>Braucht eine andere Variante: Vergleichen zeigt eine.</translation>
    </message>
    <message>
        <source>Needs a cast in both variants.</source>
        <translation>Braucht einen Guss in beiden Varianten.</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>A half meets the cast</source>
        <translation>Eine Hälfte trifft den Guss</translation>
    </message>
</context>
<context>
    <name>Guides</name>
    <message>
        <source>{0} could not be read.</source>
        <translation>{0} ließ sich nicht lesen.</translation>
    </message>
    <message>
        <source>{0} is not JSON: it goes wrong at byte {1}.</source>
        <translation>{0} ist kein JSON: Beim Byte {1} stimmt es nicht mehr.</translation>
    </message>
    <message>
        <source>{0} has no list &quot;{1}&quot;.</source>
        <translation>{0} hat keine Liste „{1}“.</translation>
    </message>
    <message>
        <source>{0}: the &quot;faces&quot; of region {1} have to be numbers from 0 to {2}.</source>
        <translation>{0}: Die „faces“ der Region {1} müssen Zahlen von 0 bis {2} sein.</translation>
    </message>
    <message>
        <source>{0}: region {1} needs a &quot;centre&quot; of three numbers and a positive &quot;radius&quot;, or a list of &quot;faces&quot;.</source>
        <translation>{0}: Region {1} braucht ein „centre“ aus drei Zahlen und einen positiven „radius“ oder eine Liste von „faces“.</translation>
    </message>
    <message>
        <source>{0}: region {1} has no face of the part in it.</source>
        <translation>{0}: In der Region {1} liegt keine Fläche des Teils.</translation>
    </message>
    <message>
        <source>{0}: the &quot;keep_within&quot; of region {1} has to be a positive number of millimetres.</source>
        <translation>{0}: Das „keep_within“ der Region {1} muss eine positive Zahl in Millimetern sein.</translation>
    </message>
    <message>
        <source>{0}: pin {1} needs a &quot;point&quot; of three numbers.</source>
        <translation>{0}: Heftpunkt {1} braucht einen „point“ aus drei Zahlen.</translation>
    </message>
    <message>
        <source>{0}: pin {1} lies {2} mm outside the part. Pins are in the part&apos;s millimetres, after --units, --scale or --size.</source>
        <translation>{0}: Heftpunkt {1} liegt {2} mm außerhalb des Teils. Heftpunkte sind in den Millimetern des Teils, nach --units, --scale oder --size.</translation>
    </message>
    <message>
        <source>{0}: region {1} needs a &quot;weight&quot; from 1 (like the rest) to 65536, or with &quot;faces&quot; a list of such, one for each.</source>
        <translation>{0}: Region {1} braucht ein &quot;weight&quot; von 1 (wie der Rest) bis 65536, oder mit &quot;faces&quot; eine Liste davon, eines für jede.</translation>
    </message>
    <message>
        <source>{0}: entry {1} puts a feature to another place than an entry before it.</source>
        <translation>{0}: Eintrag {1} setzt ein Element an einen anderen Ort als ein früherer Eintrag.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is no place of a cavity: write x, y and, if it is turned, an angle in degrees; a semicolon between places.</source>
        <translation>„{0}“ ist kein Platz einer Kavität: Schreiben Sie x, y und, wenn sie gedreht ist, einen Winkel in Grad; zwischen Plätzen ein Semikolon.</translation>
    </message>
    <message>
        <source>The place of cavity {0} needs &quot;at&quot; with two numbers, mm.</source>
        <translation>Der Platz von Kavität {0} braucht „at“ mit zwei Zahlen, mm.</translation>
    </message>
    <message>
        <source>{0}: entry {1} needs a &quot;kind&quot; (spout, vent, key, slit, bolt, ejector, overflow or pocket), a &quot;number&quot; from 1, and &quot;at&quot; with two numbers, mm.</source>
        <translation>{0}: Eintrag {1} braucht ein „kind“ (spout, vent, key, slit, bolt, ejector, overflow oder pocket), eine „number“ ab 1 und „at“ mit zwei Zahlen in mm.</translation>
    </message>
</context>
<context>
    <name>ImportancePages</name>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Brush radius</source>
        <translation>Pinselradius</translation>
    </message>
    <message>
        <source>Measured over the surface, so the brush does not jump to a near wall.</source>
        <translation>Über die Oberfläche gemessen, damit der Pinsel nicht auf eine nahe Wand springt.</translation>
    </message>
    <message>
        <source>Stop at creases</source>
        <translation>Halt an Kanten</translation>
    </message>
    <message>
        <source>How sharp an edge must be for the face tool to end there.</source>
        <translation>Wie scharf eine Kante sein muss, damit das Flächenwerkzeug dort endet.</translation>
    </message>
    <message>
        <source>Each stroke doubles the weight of what it covers; with Ctrl it halves it.</source>
        <translation>Jeder Strich verdoppelt das Gewicht dessen, was er bedeckt; mit Strg halbiert er es.</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Wichtigkeit</translation>
    </message>
    <message>
        <source>What is painted keeps its shape; the rest gives way.</source>
        <translation>Was gemalt ist, behält seine Form; der Rest gibt nach.</translation>
    </message>
    <message>
        <source>All regions</source>
        <translation>Alle Regionen</translation>
    </message>
    <message>
        <source>No region yet. A stroke makes one; F2 gives it a name.</source>
        <translation>Noch keine Region. Ein Strich bildet eine; F2 gibt ihr einen Namen.</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regionen</translation>
    </message>
    <message>
        <source>Within their limits</source>
        <translation>In ihren Grenzen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>The heaviest of its faces. Typed, it is given to all of them; 1 is only measured.</source>
        <translation>Das ihrer schwersten Fläche. Eingegeben gilt es für alle; mit 1 wird nur gemessen.</translation>
    </message>
    <message>
        <source>Keep within ±</source>
        <translation>Form halten auf ±</translation>
    </message>
    <message>
        <source>How far its points may move against each other; 0 is no limit.</source>
        <translation>Wie weit sich ihre Punkte gegeneinander bewegen dürfen; 0 ist keine Grenze.</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Measured in the cast</source>
        <translation>Am Gussteil gemessen</translation>
    </message>
    <message>
        <source>Largest change</source>
        <translation>Größte Änderung</translation>
    </message>
    <message>
        <source>Of its shape, wherever it went as a whole: after its own best fit.</source>
        <translation>Ihrer Form, wohin sie auch als Ganzes ging: nach ihrer eigenen besten Einpassung.</translation>
    </message>
    <message>
        <source>Mean change</source>
        <translation>Mittlere Änderung</translation>
    </message>
    <message>
        <source>Root of the mean square.</source>
        <translation>Wurzel des mittleren Quadrats.</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>How much its surface was stretched.</source>
        <translation>Wie stark ihre Oberfläche gedehnt wurde.</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>%1 regions</source>
        <translation>%1 Regionen</translation>
    </message>
</context>
<context>
    <name>ImportancePaint</name>
    <message>
        <source>Importance</source>
        <translation>Wichtigkeit</translation>
    </message>
    <message>
        <source>like the rest</source>
        <translation>wie der Rest</translation>
    </message>
    <message>
        <source>×32 or more</source>
        <translation>×32 oder mehr</translation>
    </message>
    <message>
        <source>Looking where the faces come from</source>
        <translation>Herkunft der Flächen wird gesucht</translation>
    </message>
    <message>
        <source>Not known for this shape.</source>
        <translation>Für diese Gestalt nicht bekannt.</translation>
    </message>
</context>
<context>
    <name>Materials</name>
    <message>
        <source>{0} is not a table of materials: {1}.</source>
        <translation>{0} ist keine Werkstofftabelle: {1}.</translation>
    </message>
    <message>
        <source>There is no material {0}. Known are: {1}.</source>
        <translation>Den Werkstoff {0} gibt es nicht. Bekannt sind: {1}.</translation>
    </message>
    <message>
        <source>{0}: the material {1} cannot be right. {2}</source>
        <translation>{0}: Das Material {1} kann nicht stimmen. {2}</translation>
    </message>
    <message>
        <source>A material needs a name.</source>
        <translation>Ein Material braucht einen Namen.</translation>
    </message>
    <message>
        <source>Shrink must be between −50 and 50 %.</source>
        <translation>Die Schwindung muss zwischen −50 und 50 % liegen.</translation>
    </message>
    <message>
        <source>Draft must be from 0 to less than 45°.</source>
        <translation>Die Schräge muss von 0 bis unter 45° reichen.</translation>
    </message>
    <message>
        <source>Density must be between 0 and 30 g/cm³.</source>
        <translation>Die Dichte muss zwischen 0 und 30 g/cm³ liegen.</translation>
    </message>
    <message>
        <source>Vents must be more than 0 and at most 5 mm deep.</source>
        <translation>Entlüftungen müssen mehr als 0 und höchstens 5 mm tief sein.</translation>
    </message>
    <message>
        <source>{0} cannot be read.</source>
        <translation>{0} kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>{0} could not be removed: {1}.</source>
        <translation>{0} konnte nicht entfernt werden: {1}.</translation>
    </message>
    <message>
        <source>A material cannot be kept as “{0}”: up to 60 lower-case letters, digits and hyphens can name one.</source>
        <translation>Ein Material kann nicht als „{0}“ behalten werden: bis zu 60 Kleinbuchstaben, Ziffern und Bindestriche können eines benennen.</translation>
    </message>
    <message>
        <source>None of your own materials is {0}.</source>
        <translation>Keines Ihrer eigenen Materialien ist {0}.</translation>
    </message>
    <message>
        <source>Sealing the mold: {0}</source>
        <translation>Form versiegeln: {0}</translation>
    </message>
    <message>
        <source>Release agent: {0}</source>
        <translation>Trennmittel: {0}</translation>
    </message>
    <message>
        <source>Filling: {0}</source>
        <translation>Füllen: {0}</translation>
    </message>
    <message>
        <source>Setting: {0}</source>
        <translation>Erhärten: {0}</translation>
    </message>
    <message>
        <source>Preparation by {0}.</source>
        <translation>Vorbereitung nach {0}.</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Schwindung</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Depth of vents in the parting plane</source>
        <translation>Tiefe der Entlüftungen in der Trennebene</translation>
    </message>
    <message>
        <source>{0}: {1} is set otherwise here; usual is {2} ({3}).</source>
        <translation>{0}: {1} ist hier anders gesetzt; üblich sind {2} ({3}).</translation>
    </message>
    <message>
        <source>{0}: {1} {2} ({3}).</source>
        <translation>{0}: {1} {2} ({3}).</translation>
    </message>
    <message>
        <source>{0}: {1} {2} ({3}; {4}).</source>
        <translation>{0}: {1} {2} ({3}; {4}).</translation>
    </message>
    <message>
        <source>The cast was designed with {0}° of draft; {1} usually asks for {2}° ({3}).</source>
        <translation>Der Guss wurde mit {0}° Schräge entworfen; {1} verlangt üblicherweise {2}° ({3}).</translation>
    </message>
    <message>
        <source>sourced</source>
        <translation>belegt</translation>
    </message>
    <message>
        <source>no source</source>
        <translation>ohne Quelle</translation>
    </message>
    <message>
        <source>make a coupon</source>
        <translation>Probe gießen</translation>
    </message>
    <message>
        <source>ask the data sheet</source>
        <translation>Datenblatt fragen</translation>
    </message>
    <message>
        <source>sources disagree</source>
        <translation>Quellen uneins</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS</translation>
    </message>
    <message>
        <source>Polypropylene</source>
        <translation>Polypropylen</translation>
    </message>
    <message>
        <source>HDPE</source>
        <translation>HDPE</translation>
    </message>
    <message>
        <source>PA 66</source>
        <translation>PA 66</translation>
    </message>
    <message>
        <source>POM</source>
        <translation>POM</translation>
    </message>
    <message>
        <source>Polycarbonate</source>
        <translation>Polycarbonat</translation>
    </message>
    <message>
        <source>PMMA</source>
        <translation>PMMA</translation>
    </message>
    <message>
        <source>Polystyrene</source>
        <translation>Polystyrol</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>Zinc alloy</source>
        <translation>Zinklegierung</translation>
    </message>
    <message>
        <source>Bronze</source>
        <translation>Bronze</translation>
    </message>
    <message>
        <source>Grey iron</source>
        <translation>Grauguss</translation>
    </message>
    <message>
        <source>Silicone (LSR)</source>
        <translation>Silikon (LSR)</translation>
    </message>
    <message>
        <source>Polyurethane resin</source>
        <translation>Polyurethanharz</translation>
    </message>
    <message>
        <source>Polyurethane foam</source>
        <translation>Polyurethanschaum</translation>
    </message>
    <message>
        <source>Plaster</source>
        <translation>Gips</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>Wachs</translation>
    </message>
    <message>
        <source>Concrete</source>
        <translation>Beton</translation>
    </message>
    <message>
        <source>Chocolate</source>
        <translation>Schokolade</translation>
    </message>
    <message>
        <source>Gummy candy</source>
        <translation>Fruchtgummi</translation>
    </message>
    <message>
        <source>injection</source>
        <translation>Spritzguss</translation>
    </message>
    <message>
        <source>gravity, permanent mold</source>
        <translation>Kokillenguss</translation>
    </message>
    <message>
        <source>die casting</source>
        <translation>Druckguss</translation>
    </message>
    <message>
        <source>sand</source>
        <translation>Sandguss</translation>
    </message>
    <message>
        <source>pour or injection</source>
        <translation>Gießen oder Spritzgießen</translation>
    </message>
    <message>
        <source>pour</source>
        <translation>Gießen</translation>
    </message>
    <message>
        <source>mold makers' shrink charts (mfgabc.com, techni-mold.com)</source>
        <translation>Schwindungstabellen von Formenbauern (mfgabc.com, techni-mold.com)</translation>
    </message>
    <message>
        <source>mold makers' guides: 1° usual, 0.5° least, 1.5° easy</source>
        <translation>Leitfäden von Formenbauern: 1° üblich, 0,5° mindestens, 1,5° bequem</translation>
    </message>
    <message>
        <source>makers' data sheets</source>
        <translation>Datenblätter der Hersteller</translation>
    </message>
    <message>
        <source>ptonline.com, viewmold.com</source>
        <translation>ptonline.com und viewmold.com</translation>
    </message>
    <message>
        <source>calculatoredge.com chart, foundry texts</source>
        <translation>Tabelle von calculatoredge.com, Gießereiliteratur</translation>
    </message>
    <message>
        <source>permanent mold practice (dynacast.com, watry.com); die casting 2°</source>
        <translation>Kokillenpraxis (dynacast.com, watry.com); Druckguss 2°</translation>
    </message>
    <message>
        <source>tables of metals</source>
        <translation>Metalltabellen</translation>
    </message>
    <message>
        <source>dynacast.com</source>
        <translation>Angaben von dynacast.com</translation>
    </message>
    <message>
        <source>foundry practice</source>
        <translation>Gießereipraxis</translation>
    </message>
    <message>
        <source>silicone.pro</source>
        <translation>Angaben von silicone.pro</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>keine gefunden</translation>
    </message>
    <message>
        <source>resin makers</source>
        <translation>Harzhersteller</translation>
    </message>
    <message>
        <source>[Stein 2019]</source>
        <translation>nach [Stein 2019]</translation>
    </message>
    <message>
        <source>foam makers</source>
        <translation>Schaumhersteller</translation>
    </message>
    <message>
        <source>plaster tables</source>
        <translation>Gipstabellen</translation>
    </message>
    <message>
        <source>measurements of beeswax</source>
        <translation>Messungen an Bienenwachs</translation>
    </message>
    <message>
        <source>tables</source>
        <translation>Tabellenwerke</translation>
    </message>
    <message>
        <source>concrete tables</source>
        <translation>Betontabellen</translation>
    </message>
    <message>
        <source>caststone.org</source>
        <translation>Angaben von caststone.org</translation>
    </message>
    <message>
        <source>a chocolate mold maker: about 1 % by volume</source>
        <translation>ein Hersteller von Schokoladenformen: etwa 1 % des Volumens</translation>
    </message>
    <message>
        <source>a chocolate mold maker</source>
        <translation>ein Hersteller von Schokoladenformen</translation>
    </message>
    <message>
        <source>0.4 to 0.9</source>
        <translation>0,4 bis 0,9</translation>
    </message>
    <message>
        <source>1.0 to 2.5</source>
        <translation>1,0 bis 2,5</translation>
    </message>
    <message>
        <source>0.025 to 0.038</source>
        <translation>0,025 bis 0,038</translation>
    </message>
    <message>
        <source>0.013 to 0.030</source>
        <translation>0,013 bis 0,030</translation>
    </message>
    <message>
        <source>0.008 to 0.013</source>
        <translation>0,008 bis 0,013</translation>
    </message>
    <message>
        <source>1.25 to 1.8</source>
        <translation>1,25 bis 1,8</translation>
    </message>
    <message>
        <source>-0.08 to -0.39</source>
        <translation>−0,08 bis −0,39</translation>
    </message>
    <message>
        <source>It expands: leave it a way to overflow.</source>
        <translation>Er dehnt sich aus: Lassen Sie ihm einen Weg zum Überlaufen.</translation>
    </message>
    <message>
        <source>It expands while it sets.</source>
        <translation>Er dehnt sich beim Abbinden aus.</translation>
    </message>
    <message>
        <source>Poured hot.</source>
        <translation>Wird heiß gegossen.</translation>
    </message>
    <message>
        <source>Three layers of sealing agent on a printed mold.</source>
        <translation>Drei Schichten Versiegelung auf einer gedruckten Form.</translation>
    </message>
    <message>
        <source>One layer of release agent made for foam.</source>
        <translation>Eine Schicht Trennmittel für Schaum.</translation>
    </message>
    <message>
        <source>Pour it in and close the mold; what it expands by leaves through the spout.</source>
        <translation>Eingießen und die Form schließen; was er sich ausdehnt, tritt durch den Anguss aus.</translation>
    </message>
    <message>
        <source>As the maker of the foam says: time and temperature differ from product to product.</source>
        <translation>Nach Angabe des Herstellers: Zeit und Temperatur sind je Produkt verschieden.</translation>
    </message>
    <message>
        <source>[Stein 2019], section 7</source>
        <translation>[Stein 2019], Abschnitt 7</translation>
    </message>
    <message>
        <source>Grease the mold with canola oil.</source>
        <translation>Die Form mit Rapsöl einfetten.</translation>
    </message>
    <message>
        <source>240 ml of grape juice, 4 tablespoons of sugar and 4 of gelatin, heated on low heat for about a minute until all is dissolved and the sugar is not brown; pour it in hot and press it into every corner.</source>
        <translation>240 ml Traubensaft, 4 Esslöffel Zucker und 4 Gelatine, bei kleiner Hitze etwa eine Minute erwärmt, bis alles gelöst und der Zucker nicht braun ist; heiß eingießen und in jede Ecke drücken.</translation>
    </message>
    <message>
        <source>About 3 hours in the fridge at 4 °C; then let it dry in the air. Sugar on it keeps it from sticking.</source>
        <translation>Etwa 3 Stunden im Kühlschrank bei 4 °C; dann an der Luft trocknen lassen. Zucker darauf verhindert Kleben.</translation>
    </message>
    <message>
        <source>[Stein 2019], A.2</source>
        <translation>[Stein 2019], Anhang A.2</translation>
    </message>
</context>
<context>
    <name>Measurement</name>
    <message>
        <source>Draft %1</source>
        <translation>Schräge %1</translation>
    </message>
    <message>
        <source>thickness %1</source>
        <translation>Dicke %1</translation>
    </message>
    <message>
        <source>On the section</source>
        <translation>Auf dem Schnitt</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
</context>
<context>
    <name>MessageDelegate</name>
    <message>
        <source>Show me</source>
        <translation>Zeigen</translation>
    </message>
</context>
<context>
    <name>Mold</name>
    <message>
        <source>No mold can be built round this cast. {0} Finish the cast first.</source>
        <translation>Um diesen Guss lässt sich keine Form bauen. {0} Erst den Guss fertigstellen.</translation>
    </message>
    <message>
        <source>Building the mold was cancelled.</source>
        <translation>Der Formenbau wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Writing the mold was cancelled.</source>
        <translation>Das Schreiben der Form wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The 3MF file could not be made: lib3mf failed to {0}.</source>
        <translation>Die 3MF-Datei ließ sich nicht schreiben: lib3mf scheiterte an {0}.</translation>
    </message>
    <message>
        <source>A channel&apos;s wall would have to lie flat to leave along the removal directions with {0}°.</source>
        <translation>Die Wand eines Kanals müsste flach liegen, um sich entlang der Entformungsrichtungen mit {0}° zu lösen.</translation>
    </message>
    <message>
        <source>A runner can only be {0} mm deep here, which is too little for the gates that open into it. Take a wider spout or narrower gates.</source>
        <translation>Ein Verteilerkanal kann hier nur {0} mm tief sein, zu wenig für die Anschnitte, die in ihn münden. Ein breiterer Einguss oder schmalere Anschnitte helfen.</translation>
    </message>
    <message>
        <source>Every second cavity cannot be turned: its faces would leave with {0}°, {1}° are required. Turned copies need removal directions normal to the plane.</source>
        <translation>Nicht jede zweite Kavität kann gedreht werden: Ihre Flächen würden sich mit {0}° lösen, {1}° sind gefordert. Gedrehte Kopien brauchen Entformungsrichtungen senkrecht zur Ebene.</translation>
    </message>
    <message>
        <source>Every second cavity cannot be turned over: its faces would leave with {0}°, {1}° are required. That needs removal directions that the half-turn exchanges.</source>
        <translation>Nicht jede zweite Kavität kann gewendet werden: Ihre Flächen würden sich mit {0}° lösen, {1}° sind gefordert. Das verlangt Entformungsrichtungen, die die halbe Drehung vertauscht.</translation>
    </message>
    <message>
        <source>Every second cavity cannot be mirrored: its faces would leave with {0}°, {1}° are required. That needs removal directions in the mirror&apos;s plane.</source>
        <translation>Nicht jede zweite Kavität kann gespiegelt werden: Ihre Flächen würden sich mit {0}° lösen, {1}° sind gefordert. Das verlangt Entformungsrichtungen in der Spiegelebene.</translation>
    </message>
    <message>
        <source>The channels could not be joined to the cavity soundly at any of {0} nearby places. Another pour direction or gate width may help.</source>
        <translation>Die Kanäle ließen sich an keiner von {0} nahen Stellen fehlerfrei mit der Kavität verbinden. Eine andere Gießrichtung oder Anschnittbreite kann helfen.</translation>
    </message>
    <message>
        <source>A gate {0} mm wide would be wider than the cavity where it is filled: there it is {1} mm wide.</source>
        <translation>Ein Anschnitt von {0} mm Breite wäre breiter als die Kavität, wo sie gefüllt wird: Dort ist er {1} mm breit.</translation>
    </message>
    <message>
        <source>The way from a cavity&apos;s gate to the runner passes through another part of the cavity. Choose another pour direction.</source>
        <translation>Der Weg vom Anschnitt einer Kavität zum Verteilerkanal führt durch einen anderen Teil der Kavität. Bitte eine andere Gießrichtung wählen.</translation>
    </message>
    <message>
        <source>Vents need a spout: without one nothing tells which way is up while the mold is filled.</source>
        <translation>Entlüftungen brauchen einen Einguss: Ohne ihn ist nicht bestimmt, wo beim Füllen oben ist.</translation>
    </message>
    <message>
        <source>A shrink of {0} % is no shrink of a material: give less than 50 %.</source>
        <translation>{0} % ist keine Schwindung eines Werkstoffs: bitte weniger als 50 % angeben.</translation>
    </message>
    <message>
        <source>The parting face could not be built: features meet in the parting plane.</source>
        <translation>Die Trennfläche ließ sich nicht bilden: Merkmale treffen in der Trennebene aufeinander.</translation>
    </message>
    <message>
        <source>A wall at the parting plane would have to lie flat to leave along the removal directions with {0}°.</source>
        <translation>Eine Wand an der Trennebene müsste flach liegen, um sich entlang der Entformungsrichtungen mit {0}° zu lösen.</translation>
    </message>
    <message>
        <source>Only {0} of {1} ejector pins find a place in half {2}: a pin of {3} mm needs ground that is flat within 35°, away from the parting line and the gate. Ask for fewer or thinner pins, or the other half.</source>
        <translation>Nur {0} von {1} Auswerferstiften finden in Hälfte {2} Platz: Ein Stift von {3} mm braucht Grund, der auf 35° eben ist, fern von Trennlinie und Anschnitt. Verlangen Sie weniger oder dünnere Stifte, oder die andere Hälfte.</translation>
    </message>
    <message>
        <source>A spout through half 1 finds no place: its neck of {0} mm has no room on the cavity there. Take a thinner neck, or let the mold stand.</source>
        <translation>Ein Einguss durch Hälfte 1 findet keinen Platz: Sein Hals von {0} mm passt dort nicht auf den Hohlraum. Nehmen Sie einen dünneren Hals, oder lassen Sie die Form stehen.</translation>
    </message>
    <message>
        <source>No block of the stock is large enough: the longest has {0} mm.</source>
        <translation>Kein Block des Vorrats ist groß genug: Der längste misst {0} mm.</translation>
    </message>
    <message>
        <source>Ejector hole {0} cannot enter the cavity of half {1} there: a pin of {2} mm needs ground that is flat within 35°, {3} mm from the parting line.</source>
        <translation>Auswerferloch {0} kann dort nicht in die Kavität von Hälfte {1} treten: Ein Stift von {2} mm braucht Grund, der auf 35° eben ist, {3} mm von der Trennlinie.</translation>
    </message>
    <message>
        <source>Spout {0} cannot enter its cavity there: its neck of {1} mm has no room, or the ground is steeper than 70°.</source>
        <translation>Anguss {0} kann dort nicht in seine Kavität treten: Sein Hals von {1} mm hat keinen Platz, oder der Grund ist steiler als 70°.</translation>
    </message>
    <message>
        <source>Vent {0} would stand beside the {1} mm³ of air that it is to let out. Keep it over them, or have it placed automatically.</source>
        <translation>Entlüftung {0} stünde neben den {1} mm³ Luft, die sie ablassen soll. Lassen Sie sie darüber, oder lassen Sie sie automatisch platzieren.</translation>
    </message>
    <message>
        <source>Vent {0} has no way out of the cavity there: it needs room for a foot wholly inside the cast, and nothing in its way.</source>
        <translation>Entlüftung {0} hat dort keinen Weg aus der Kavität: Sie braucht Platz für einen Fuß ganz im Abguss, und nichts darf im Weg sein.</translation>
    </message>
    <message>
        <source>At x = {0} mm the spout has no room between the gates beside it. Move it away from them.</source>
        <translation>Bei x = {0} mm hat der Anguss zwischen den Anschnitten daneben keinen Platz. Rücken Sie ihn von ihnen weg.</translation>
    </message>
    <message>
        <source>At x = {0} mm a spout {1} mm wide does not meet the cavity&apos;s parting line from above, which reaches from {2} to {3} mm. Move it inwards, or make its end narrower.</source>
        <translation>Bei x = {0} mm trifft ein {1} mm breiter Anguss die Trennlinie der Kavität nicht von oben; sie reicht von {2} bis {3} mm. Rücken Sie ihn nach innen, oder machen Sie sein Ende schmaler.</translation>
    </message>
    <message>
        <source>There is no steel between {0} and {1}. Move one of them, or have it placed automatically.</source>
        <translation>Zwischen {0} und {1} ist kein Stahl. Rücken Sie eines davon weg, oder lassen Sie es automatisch platzieren.</translation>
    </message>
    <message>
        <source>No feature can stand {0} mm from the middle: blocks of this mold reach no farther than {1} mm.</source>
        <translation>Kein Element kann {0} mm von der Mitte stehen: Blöcke dieser Form reichen höchstens {1} mm weit.</translation>
    </message>
    <message>
        <source>An outer face of the block would have to lie flat to have {0}° of draft along the removal directions.</source>
        <translation>Eine Außenfläche des Blocks müsste flach liegen, um entlang der Entformungsrichtungen {0}° Schräge zu haben.</translation>
    </message>
    <message>
        <source>The block&apos;s outer faces meet before its back: take less draft.</source>
        <translation>Die Außenflächen des Blocks treffen sich vor seiner Rückseite: weniger Schräge nehmen.</translation>
    </message>
    <message>
        <source>Every second cavity can be another one in rows only, not on a circle or in a free layout.</source>
        <translation>Jede zweite Kavität kann nur in Reihen eine andere sein, nicht auf einem Kreis oder in freier Anordnung.</translation>
    </message>
    <message>
        <source>On a circle each cavity is filled at one place, from the middle. This cast is of {0} solids: arrange it in rows, or fill it through half 1.</source>
        <translation>Auf einem Kreis wird jede Kavität an einer Stelle gefüllt, von der Mitte aus. Dieser Guss hat {0} Körper: ordnen Sie ihn in Reihen an, oder füllen Sie ihn durch Hälfte 1.</translation>
    </message>
    <message>
        <source>Cavities {0} and {1} stand {2} mm apart; {3} mm of steel are asked for between them.</source>
        <translation>Die Kavitäten {0} und {1} stehen {2} mm auseinander; zwischen ihnen sind {3} mm Stahl verlangt.</translation>
    </message>
    <message>
        <source>The spout of cavity {0} passes too near to cavity {1} or its spout. Move one of them, or fill them through half 1.</source>
        <translation>Der Einguss von Kavität {0} verläuft zu nah an Kavität {1} oder deren Einguss. Verschieben Sie eine davon, oder füllen Sie durch Hälfte 1.</translation>
    </message>
    <message>
        <source>A free layout needs at least one place for a cavity.</source>
        <translation>Eine freie Anordnung braucht mindestens einen Platz für eine Kavität.</translation>
    </message>
    <message>
        <source>Cavity {0} cannot be turned by {1}°: its faces would leave with {2}°, {3}° are required. Turned copies need removal directions normal to the plane.</source>
        <translation>Kavität {0} kann nicht um {1}° gedreht werden: Ihre Flächen kämen mit {2}° heraus, verlangt sind {3}°. Gedrehte Kopien brauchen Entformungsrichtungen senkrecht zur Ebene.</translation>
    </message>
    <message>
        <source>Overflow {0} would stand {1} mm from its cavity's parting line. Keep it within {2} mm, or have it placed automatically.</source>
        <translation>Überlauf {0} stünde {1} mm von der Trennlinie seiner Kavität entfernt. Bleiben Sie innerhalb von {2} mm, oder lassen Sie ihn automatisch setzen.</translation>
    </message>
    <message>
        <source>Overflow {0} cannot stand there: its channel would meet another part of the cavity. Move it, or have it placed automatically.</source>
        <translation>Überlauf {0} kann dort nicht stehen: Sein Kanal träfe auf einen anderen Teil der Kavität. Verschieben Sie ihn, oder lassen Sie ihn automatisch setzen.</translation>
    </message>
    <message>
        <source>There is no room for {0} overflows {1} mm wide at each cavity. Ask for fewer or smaller ones, or for more steel between the cavities.</source>
        <translation>An jeder Kavität ist kein Platz für {0} Überläufe von {1} mm Breite. Verlangen Sie weniger oder kleinere, oder mehr Stahl zwischen den Kavitäten.</translation>
    </message>
    <message>
        <source>Overflow {0} would stand where the cavity is filled. Move it, or have it placed automatically.</source>
        <translation>Überlauf {0} stünde dort, wo die Kavität gefüllt wird. Verschieben Sie ihn, oder lassen Sie ihn automatisch setzen.</translation>
    </message>
    <message>
        <source>Overflows need a spout: without one nothing tells where material arrives last.</source>
        <translation>Überläufe brauchen einen Einguss: Ohne ihn ist nicht bestimmt, wo das Material zuletzt ankommt.</translation>
    </message>
    <message>
        <source>The channel of overflow {0} has no room in the wall of its well. Make the channel narrower or the well wider.</source>
        <translation>Der Kanal von Überlauf {0} hat in der Wand seiner Mulde keinen Platz. Machen Sie den Kanal schmaler oder die Mulde breiter.</translation>
    </message>
    <message>
        <source>A mold cannot lean by {0}° while it is filled: 0 to {1}° are possible.</source>
        <translation>Eine Form kann beim Füllen nicht um {0}° geneigt sein: 0 bis {1}° sind möglich.</translation>
    </message>
    <message>
        <source>There is no room for {0} keys, {1} slits, {2} bolt holes and {3} pockets. Ask for fewer or smaller ones.</source>
        <translation>Es ist kein Platz für {0} Zapfen, {1} Schlitze, {2} Schraubenlöcher und {3} Einlegertaschen. Verlangen Sie weniger oder kleinere.</translation>
    </message>
    <message>
        <source>Measuring the steel was cancelled.</source>
        <translation>Das Messen des Stahls wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is no letter &quot;{0}&quot; for a plaque. There are A to Z, 0 to 9, letters with Western marks, and - . , : / % ° # + ( ).</source>
        <translation>Für ein Schild gibt es das Zeichen „{0}“ nicht. Es gibt A bis Z, 0 bis 9, Buchstaben mit westlichen Zeichen und - . , : / % ° # + ( ).</translation>
    </message>
    <message>
        <source>The plaque&apos;s text has no room on the back of half {0}, not even with letters of {1} mm. Take smaller letters, fewer words, more lines (| between them) or a larger block.</source>
        <translation>Die Schrift des Schildes hat auf dem Rücken von Hälfte {0} keinen Platz, auch nicht mit Buchstaben von {1} mm. Nehmen Sie kleinere Buchstaben, weniger Wörter, mehr Zeilen (dazwischen |) oder einen größeren Block.</translation>
    </message>
    <message>
        <source>Letters of {0} mm have strokes of {1} mm, and less than {2} mm cannot be printed or read. Make them {3} mm high or more.</source>
        <translation>Buchstaben von {0} mm haben Striche von {1} mm; unter {2} mm lassen sie sich nicht drucken oder lesen. Machen Sie sie {3} mm hoch oder höher.</translation>
    </message>
    <message>
        <source>A plaque {0} mm deep leaves less than {1} mm of steel to the cavities. Make it shallower, or floor and ceiling thicker.</source>
        <translation>Ein {0} mm tiefes Schild lässt weniger als {1} mm Stahl bis zu den Kavitäten. Machen Sie es flacher oder Boden und Decke dicker.</translation>
    </message>
    <message>
        <source>Letters of {0} mm are too small for a plaque {1} mm deep: their walls meet. Make it shallower, or them larger.</source>
        <translation>Buchstaben von {0} mm sind zu klein für ein {1} mm tiefes Schild: Ihre Wände treffen sich. Machen Sie es flacher oder die Buchstaben größer.</translation>
    </message>
    <message>
        <source>Pockets {0} mm deep leave less than {1} mm of steel at the back of half {2}. Make them shallower, or the half thicker.</source>
        <translation>{0} mm tiefe Taschen lassen am Rücken von Hälfte {2} weniger als {1} mm Stahl. Machen Sie sie flacher oder die Hälfte dicker.</translation>
    </message>
    <message>
        <source>The cavities do not fill at the same time: the ways to them are {0} to {1} mm long.</source>
        <translation>Die Kavitäten füllen sich nicht gleichzeitig: Die Wege zu ihnen sind {0} bis {1} mm lang.</translation>
    </message>
    <message>
        <source>The spout stands at x = {0} mm, not where it was put: only from there all ways to the cavities are of one length. It can be moved where rows have the shortest runners.</source>
        <translation>Der Anguss steht bei x = {0} mm, nicht wo er hingesetzt wurde: Nur von dort sind alle Wege zu den Kavitäten gleich lang. Versetzen lässt er sich bei Reihen mit den kürzesten Verteilerkanälen.</translation>
    </message>
    <message>
        <source>Its walls lean up to {0}°: with less it would hold when one half is opened first.</source>
        <translation>Seine Wände neigen sich bis {0}°: Mit weniger hielte er, wenn eine Hälfte zuerst geöffnet wird.</translation>
    </message>
    <message>
        <source>No vent can be placed here, or none that reaches higher.</source>
        <translation>Hier kann keine Entlüftung stehen, oder keine, die höher reicht.</translation>
    </message>
    <message>
        <source>Widens outwards: it breaks off at its neck when half 1 is taken off, and is pushed out of it outwards.</source>
        <translation>Wird nach außen weiter: Er bricht am Hals ab, wenn Hälfte 1 abgenommen wird, und wird nach außen aus ihr gedrückt.</translation>
    </message>
    <message>
        <source>Reads: {0}</source>
        <translation>Text: {0}</translation>
    </message>
    <message>
        <source>Each spout through half 1 holds its sprue and breaks off at a neck of {0} mm: the cast is proved without it. Push the sprues out of half 1 outwards.</source>
        <translation>Jeder Anguss durch Hälfte 1 hält seinen Zapfen und bricht an einem Hals von {0} mm ab: Der Guss ist ohne ihn bewiesen. Drücken Sie die Angusszapfen nach außen aus Hälfte 1.</translation>
    </message>
    <message>
        <source>Only {0} mm of steel between {1} and {2}.</source>
        <translation>Nur {0} mm Stahl zwischen {1} und {2}.</translation>
    </message>
    <message>
        <source>Half {0} of {1} is larger than the printer&apos;s {2}.</source>
        <translation>Hälfte {0} mit {1} ist größer als die {2} des Druckers.</translation>
    </message>
    <message>
        <source>The mold needs {0} kN to stay closed; the press has {1} kN.</source>
        <translation>Die Form braucht {0} kN, um geschlossen zu bleiben; die Presse hat {1} kN.</translation>
    </message>
    <message>
        <source>Shrinking differently along the axes turns faces: the draft falls to {0}°. Design the cast with {1}°.</source>
        <translation>Verschiedene Schwindung entlang der Achsen dreht Flächen: Die Schräge fällt auf {0}°. Entwerfen Sie den Guss mit {1}°.</translation>
    </message>
    <message>
        <source>The removal directions do not allow turned copies: on the circle they are only moved, and each is filled on another of its sides.</source>
        <translation>Die Entformungsrichtungen erlauben keine gedrehten Kopien: Auf dem Kreis sind sie nur verschoben, und jede wird an einer anderen Seite gefüllt.</translation>
    </message>
    <message>
        <source>While it is filled the mold is tilted by {0}° towards {1}: {2} mm³ of air stay instead of {3}.</source>
        <translation>Beim Füllen ist die Form um {0}° zu {1} geneigt: {2} mm³ Luft bleiben statt {3}.</translation>
    </message>
    <message>
        <source>Tilt the mold by {0}° towards {1} while it is filled: trapped air falls from {3} to {2} mm³.</source>
        <translation>Neigen Sie die Form beim Füllen um {0}° zu {1}: Die eingeschlossene Luft fällt von {3} auf {2} mm³.</translation>
    </message>
    <message>
        <source>Balanced runners part in two at each joint: rows and columns must each be 1, 2, 4, 8 or another power of two. Here there are {0} and {1}.</source>
        <translation>Ausgeglichene Verteilerkanäle teilen sich an jeder Verbindung in zwei: Zeilen und Spalten müssen je 1, 2, 4, 8 oder eine andere Zweierpotenz sein. Hier sind es {0} und {1}.</translation>
    </message>
    <message>
        <source>Balanced runners lead along straight columns: they need a grid, not rows that are moved against each other.</source>
        <translation>Ausgeglichene Verteilerkanäle führen an geraden Spalten entlang: Sie brauchen ein Raster, keine gegeneinander versetzten Zeilen.</translation>
    </message>
    <message>
        <source>Balanced runners fill each cavity at one place. This cast is of {0} solids: take the shortest runners, or fill it through half 1.</source>
        <translation>Ausgeglichene Verteilerkanäle füllen jede Kavität an einer Stelle. Dieses Gussteil besteht aus {0} Körpern: Nehmen Sie die kürzesten Verteilerkanäle, oder füllen Sie durch Hälfte 1.</translation>
    </message>
    <message>
        <source>The gates of every second cavity stand too far aside for runners of one length. Take copies that are all alike, or the shortest runners.</source>
        <translation>Die Anschnitte jeder zweiten Kavität liegen für gleich lange Verteilerkanäle zu weit seitlich. Nehmen Sie lauter gleiche Kopien oder die kürzesten Verteilerkanäle.</translation>
    </message>
    <message>
        <source>A mold cannot have {0} cavities of {1}: 1 to {2} are possible.</source>
        <translation>Eine Form kann nicht {0} Kavitäten von {1} haben: möglich sind 1 bis {2}.</translation>
    </message>
    <message>
        <source>The free layout has {0} places; the parts of this mold ask for {1}.</source>
        <translation>Die freie Anordnung hat {0} Plätze; die Teile dieser Form verlangen {1}.</translation>
    </message>
    <message>
        <source>{0} cannot stand in this mold: along the mold&apos;s removal directions its faces would leave with {1}° at best, {2}° are required. Design both parts with directions normal to the plane, or with the same ones.</source>
        <translation>{0} kann nicht in dieser Form stehen: Entlang der Entformungsrichtungen der Form kämen seine Flächen bestenfalls mit {1}° heraus, verlangt sind {2}°. Beide Teile mit Richtungen senkrecht zur Ebene entwerfen, oder mit denselben.</translation>
    </message>
    <message>
        <source>{0} cannot stand in this mold. {1} Finish its cast first.</source>
        <translation>{0} kann nicht in dieser Form stehen. {1} Erst seinen Guss fertigstellen.</translation>
    </message>
    <message>
        <source>Every second cavity can be another one only where all are of one part.</source>
        <translation>Jede zweite Kavität kann nur dort eine andere sein, wo alle von einem Teil sind.</translation>
    </message>
    <message>
        <source>The layout has {0} × {1} cavities instead of {2} × {3}, so that each part has its number.</source>
        <translation>Die Anordnung hat {0} × {1} statt {2} × {3} Kavitäten, damit jedes Teil seine Anzahl hat.</translation>
    </message>
    <message>
        <source>A channel {0} mm deep closes before its floor: it is too narrow for the lean that its walls need. Make it wider, or take less draft.</source>
        <translation>Ein {0} mm tiefer Kanal schließt sich vor seinem Grund: Er ist zu schmal für die Neigung, die seine Wände brauchen. Machen Sie ihn breiter oder nehmen Sie weniger Entformungsschräge.</translation>
    </message>
    <message>
        <source>A key {0} mm wide whose walls lean {1}° comes to a point before it is {2} mm high. Make it wider, lower, or its draft smaller.</source>
        <translation>Ein {0} mm breiter Zapfen, dessen Wände {1}° geneigt sind, läuft spitz zu, bevor er {2} mm hoch ist. Machen Sie ihn breiter, niedriger oder seine Schräge kleiner.</translation>
    </message>
    <message>
        <source>A wedge slit of {0} by {1} mm cannot be {2} mm high in each half with the draft that its walls need. Make it lower, or larger.</source>
        <translation>Ein Keilschlitz von {0} mal {1} mm kann mit der Schräge, die seine Wände brauchen, nicht in jeder Hälfte {2} mm hoch sein. Machen Sie ihn niedriger oder größer.</translation>
    </message>
    <message>
        <source>A pocket's wall would have to lie flat to leave along the removal directions with {0}°.</source>
        <translation>Eine Wand einer Tasche müsste flach liegen, um in den Entformungsrichtungen mit {0}° frei zu werden.</translation>
    </message>
    <message>
        <source>There is no steel between {0} and {1}. Give the cavities more spacing, or take fewer or smaller features.</source>
        <translation>Zwischen {0} und {1} bleibt kein Stahl. Geben Sie den Kavitäten mehr Abstand, oder nehmen Sie weniger oder kleinere Merkmale.</translation>
    </message>
    <message>
        <source>{0} meets the same of the next cavity. Give the cavities more spacing, or make it smaller.</source>
        <translation>{0} trifft auf das gleiche der nächsten Kavität. Geben Sie den Kavitäten mehr Abstand, oder machen Sie es kleiner.</translation>
    </message>
</context>
<context>
    <name>MoldFeaturePages</name>
    <message>
        <source>Drag its disc in the view, or type here.</source>
        <translation>In der Ansicht an seiner Scheibe ziehen, oder hier eintippen.</translation>
    </message>
    <message>
        <source>Place in the parting plane</source>
        <translation>Ort in der Trennebene</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Of the block, seen from half 1.</source>
        <translation>Des Blocks, von Hälfte 1 aus gesehen.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>Entlang der Kante</translation>
    </message>
    <message>
        <source>From the middle of the mold.</source>
        <translation>Von der Mitte der Form.</translation>
    </message>
    <message>
        <source>From the middle of the mold; up is where it is filled.</source>
        <translation>Von der Mitte der Form; oben wird gefüllt.</translation>
    </message>
    <message>
        <source>From the middle of its cavity; up is where it is filled.</source>
        <translation>Von der Mitte ihrer Kavität; oben wird gefüllt.</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Steht</translation>
    </message>
    <message>
        <source>Smallest steel</source>
        <translation>Kleinster Stahl</translation>
    </message>
    <message>
        <source>Between this and the nearest other feature or face of the block.</source>
        <translation>Zwischen diesem und dem nächsten anderen Element oder der Blockfläche.</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>automatically</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>All: %1</source>
        <translation>Alle: %1</translation>
    </message>
</context>
<context>
    <name>MoldPages</name>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Steel between the cavities and each side face.</source>
        <translation>Stahl zwischen den Kavitäten und jeder Seitenfläche.</translation>
    </message>
    <message>
        <source>Over half 1</source>
        <translation>Über Hälfte 1</translation>
    </message>
    <message>
        <source>Steel over the cavities of half 1.</source>
        <translation>Stahl über den Kavitäten von Hälfte 1.</translation>
    </message>
    <message>
        <source>Under half 2</source>
        <translation>Unter Hälfte 2</translation>
    </message>
    <message>
        <source>Steel under the cavities of half 2.</source>
        <translation>Stahl unter den Kavitäten von Hälfte 2.</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>Kavitäten</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Cavities in a row.</source>
        <translation>Kavitäten in einer Reihe.</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>Rows of cavities.</source>
        <translation>Reihen von Kavitäten.</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Staggered</source>
        <translation>Versetzt</translation>
    </message>
    <message>
        <source>Packed</source>
        <translation>Dicht</translation>
    </message>
    <message>
        <source>Steel between</source>
        <translation>Stahl dazwischen</translation>
    </message>
    <message>
        <source>Between cavities, and between them and channels.</source>
        <translation>Zwischen Kavitäten, und zwischen ihnen und Kanälen.</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Schwindung</translation>
    </message>
    <message>
        <source>Made larger by</source>
        <translation>Vergrößert um</translation>
    </message>
    <message>
        <source>Both are in use; at 5 % they are 1.0500 and 1.0526. The report says which.</source>
        <translation>Beide sind üblich; bei 5 % sind es 1,0500 und 1,0526. Der Bericht nennt, welche.</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Spout</source>
        <translation>Anguss</translation>
    </message>
    <message>
        <source>In the parting plane for a mold that stands on its edge; through half 1 for one that lies flat: that one breaks off at its neck.</source>
        <translation>In der Trennebene für eine Form, die auf der Kante steht; durch Hälfte 1 für eine, die flach liegt: dieser bricht am Hals ab.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>In the parting plane</source>
        <translation>In der Trennebene</translation>
    </message>
    <message>
        <source>Through half 1</source>
        <translation>Durch Hälfte 1</translation>
    </message>
    <message>
        <source>Spout&apos;s width</source>
        <translation>Weite des Angusses</translation>
    </message>
    <message>
        <source>In the parting plane; of one through half 1, above its neck.</source>
        <translation>In der Trennebene; bei einem durch Hälfte 1 über dem Hals.</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>Where a spout through half 1 breaks off.</source>
        <translation>Wo ein Anguss durch Hälfte 1 abbricht.</translation>
    </message>
    <message>
        <source>Vents</source>
        <translation>Entlüftungen</translation>
    </message>
    <message>
        <source>Where air would stay while the mold is filled.</source>
        <translation>Wo beim Füllen Luft bliebe.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Cast hollow</source>
        <translation>Hohl gießen</translation>
    </message>
    <message>
        <source>The wall that stays when the rest is poured out again; 0: solid.</source>
        <translation>Die Wand, die bleibt, wenn der Rest wieder ausgegossen wird; 0: voll.</translation>
    </message>
    <message>
        <source>Closing and opening</source>
        <translation>Schließen und Öffnen</translation>
    </message>
    <message>
        <source>Registration keys</source>
        <translation>Zentrierzapfen</translation>
    </message>
    <message>
        <source>On half 2, in sockets of half 1; one is larger, so that the halves fit one way only.</source>
        <translation>Auf Hälfte 2, in Taschen von Hälfte 1; einer ist größer, damit die Hälften nur auf eine Weise passen.</translation>
    </message>
    <message>
        <source>On all sides and in depth.</source>
        <translation>Auf allen Seiten und in der Tiefe.</translation>
    </message>
    <message>
        <source>Wedge slits</source>
        <translation>Keilschlitze</translation>
    </message>
    <message>
        <source>Notches at the edge of the plane, to pry the halves apart.</source>
        <translation>Kerben am Rand der Ebene, um die Hälften auseinanderzuhebeln.</translation>
    </message>
    <message>
        <source>Bolt holes</source>
        <translation>Schraubenlöcher</translation>
    </message>
    <message>
        <source>Straight through both halves.</source>
        <translation>Gerade durch beide Hälften.</translation>
    </message>
    <message>
        <source>Ejector holes</source>
        <translation>Auswerferlöcher</translation>
    </message>
    <message>
        <source>For each cavity.</source>
        <translation>Für jede Kavität.</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>proved</source>
        <translation>bewiesen</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Mold</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Half 1, mm</source>
        <translation>Hälfte 1, mm</translation>
    </message>
    <message>
        <source>Half 2, mm</source>
        <translation>Hälfte 2, mm</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Air that stays</source>
        <translation>Luft, die bleibt</translation>
    </message>
    <message>
        <source>Both halves</source>
        <translation>Beide Hälften</translation>
    </message>
    <message>
        <source>Clamp force</source>
        <translation>Schließkraft</translation>
    </message>
    <message>
        <source>Smallest steel</source>
        <translation>Kleinster Stahl</translation>
    </message>
    <message>
        <source>Comes off</source>
        <translation>Lässt sich abziehen</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>A box, or a shell that saves material: what holds nothing is cut away from its corners.</source>
        <translation>Ein Quader, oder eine Schale, die Material spart: Was nichts enthält, wird an den Ecken weggeschnitten.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Schale</translation>
    </message>
    <message>
        <source>Outer draft</source>
        <translation>Schräge außen</translation>
    </message>
    <message>
        <source>The outer faces widen to the back by this, so that a half that is cast leaves its form; below 0 they narrow.</source>
        <translation>Die Außenflächen werden nach hinten um so viel weiter, damit eine gegossene Hälfte ihre Form verlässt; unter 0 werden sie enger.</translation>
    </message>
    <message>
        <source>What the printer can make; a half that is larger is told of. 0: not known.</source>
        <translation>Was der Drucker herstellen kann; eine größere Hälfte wird gemeldet. 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>Stock and machines</source>
        <translation>Vorrat und Maschinen</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Vorrat</translation>
    </message>
    <message>
        <source>Lengths and widths of blocks that are to be had, in mm, a comma between; the next is taken. Empty: any.</source>
        <translation>Längen und Breiten vorhandener Blöcke in mm, mit Komma dazwischen; der nächste wird genommen. Leer: beliebig.</translation>
    </message>
    <message>
        <source>Printer&apos;s width</source>
        <translation>Breite des Druckers</translation>
    </message>
    <message>
        <source>Printer&apos;s depth</source>
        <translation>Tiefe des Druckers</translation>
    </message>
    <message>
        <source>Printer&apos;s height</source>
        <translation>Höhe des Druckers</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Presse</translation>
    </message>
    <message>
        <source>What it closes with; a mold that needs more is told of. 0: not known.</source>
        <translation>Womit sie schließt; eine Form, die mehr braucht, wird gemeldet. 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>By how much the material shrinks; the cavity is made larger by it. The same along all axes of the part until y or z differ, then along x. Less than 0: it expands.</source>
        <translation>Um wie viel das Material schwindet; um so viel wird die Kavität größer. Entlang aller Achsen des Teils gleich, bis y oder z abweichen, dann entlang x. Unter 0: Es dehnt sich aus.</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>Entlang y</translation>
    </message>
    <message>
        <source>Shrink along y of the part.</source>
        <translation>Schwindung entlang y des Teils.</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>Entlang z</translation>
    </message>
    <message>
        <source>Shrink along z of the part.</source>
        <translation>Schwindung entlang z des Teils.</translation>
    </message>
    <message>
        <source>Vents&apos; depth</source>
        <translation>Tiefe der Entlüftung</translation>
    </message>
    <message>
        <source>In the parting plane, both halves together; 0: as their width asks.</source>
        <translation>In der Trennebene, beide Hälften zusammen; 0: wie es die Breite verlangt.</translation>
    </message>
    <message>
        <source>How rows lie to each other. Packed: as close as the outlines allow. Circle: about a spout in their middle, each filled over a way of the same length. Free: at the places given.</source>
        <translation>Wie die Reihen zueinander liegen. Dicht: so eng, wie die Umrisse erlauben. Kreis: um einen Einguss in der Mitte, jede über einen gleich langen Weg gefüllt. Frei: an den angegebenen Plätzen.</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Plätze</translation>
    </message>
    <message>
        <source>Of a free layout: x and y of each cavity in mm and how far it is turned in degrees; a semicolon between cavities.</source>
        <translation>Bei freier Anordnung: x und y jeder Kavität in mm und ihre Drehung in Grad; zwischen Kavitäten ein Semikolon.</translation>
    </message>
    <message>
        <source>Overflows</source>
        <translation>Überläufe</translation>
    </message>
    <message>
        <source>Closed wells beside each solid of each cavity, for the material that arrives last.</source>
        <translation>Geschlossene Mulden neben jedem Körper jeder Kavität, für das Material, das zuletzt ankommt.</translation>
    </message>
    <message>
        <source>0.3 of the well's at most.</source>
        <translation>Höchstens 0,3 der Muldenbreite.</translation>
    </message>
    <message>
        <source>From the cavity to the well.</source>
        <translation>Von der Kavität zur Mulde.</translation>
    </message>
    <message>
        <source>Tilted</source>
        <translation>Geneigt</translation>
    </message>
    <message>
        <source>While it is filled: by number, or as the least air stays. What that would save is told when the mold is built.</source>
        <translation>Beim Füllen: nach Zahl, oder so, dass am wenigsten Luft bleibt. Was das sparen würde, wird beim Bauen der Form gesagt.</translation>
    </message>
    <message>
        <source>By number</source>
        <translation>Nach Zahl</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>How far the mold's top leans while it is filled, where that is by number.</source>
        <translation>Wie weit sich die Oberseite der Form beim Füllen neigt, wenn das nach Zahl geht.</translation>
    </message>
    <message>
        <source>Towards</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>0 to the right, 90 to half 1, or to the back of a mold that lies flat.</source>
        <translation>0 nach rechts, 90 zu Hälfte 1, oder bei einer liegenden Form nach hinten.</translation>
    </message>
    <message>
        <source>Insert pockets</source>
        <translation>Einlegertaschen</translation>
    </message>
    <message>
        <source>In the parting face, for nuts, magnets or dowels.</source>
        <translation>In der Trennfläche, für Muttern, Magnete oder Stifte.</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einleger</translation>
    </message>
    <message>
        <source>Its shape, seen along the normal.</source>
        <translation>Seine Form, entlang der Normalen gesehen.</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>Hexagon</source>
        <translation>Sechskant</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>Seine Breite</translation>
    </message>
    <message>
        <source>Diameter, across flats, or the side along y.</source>
        <translation>Durchmesser, Schlüsselweite oder die Seite entlang y.</translation>
    </message>
    <message>
        <source>Its length</source>
        <translation>Seine Länge</translation>
    </message>
    <message>
        <source>The side along x, of a rectangle.</source>
        <translation>Die Seite entlang x, bei einem Rechteck.</translation>
    </message>
    <message>
        <source>Pockets&apos; depth</source>
        <translation>Tiefe der Taschen</translation>
    </message>
    <message>
        <source>Into the half.</source>
        <translation>In die Hälfte hinein.</translation>
    </message>
    <message>
        <source>Pockets&apos; clearance</source>
        <translation>Spiel der Taschen</translation>
    </message>
    <message>
        <source>Round the insert, at the pocket&apos;s floor.</source>
        <translation>Rings um den Einleger, am Boden der Tasche.</translation>
    </message>
    <message>
        <source>Pockets in</source>
        <translation>Taschen in</translation>
    </message>
    <message>
        <source>Dowels ask for both halves.</source>
        <translation>Stifte brauchen beide Hälften.</translation>
    </message>
    <message>
        <source>Half 1</source>
        <translation>Hälfte 1</translation>
    </message>
    <message>
        <source>Half 2</source>
        <translation>Hälfte 2</translation>
    </message>
    <message>
        <source>Plaque</source>
        <translation>Schild</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Letters&apos; height</source>
        <translation>Schrifthöhe</translation>
    </message>
    <message>
        <source>Of capitals, 2.8 mm or more; 0: as large as there is room for.</source>
        <translation>Der Großbuchstaben, mindestens 2,8 mm; 0: so groß, wie Platz ist.</translation>
    </message>
    <message>
        <source>Letters&apos; depth</source>
        <translation>Schrifttiefe</translation>
    </message>
    <message>
        <source>Of their grooves.</source>
        <translation>Ihrer Rillen.</translation>
    </message>
    <message>
        <source>Halves 1 and 2</source>
        <translation>Hälften 1 und 2</translation>
    </message>
    <message>
        <source>Runners</source>
        <translation>Verteilerkanäle</translation>
    </message>
    <message>
        <source>From a spout in the parting plane to cavities in rows and columns: the shortest, or all ways equally long, so that the cavities fill together.</source>
        <translation>Vom Einguss in der Teilungsebene zu Kavitäten in Zeilen und Spalten: die kürzesten, oder alle Wege gleich lang, damit sich die Kavitäten zugleich füllen.</translation>
    </message>
    <message>
        <source>Shortest</source>
        <translation>Die kürzesten</translation>
    </message>
    <message>
        <source>Equally long</source>
        <translation>Gleich lang</translation>
    </message>
    <message>
        <source>Least steel</source>
        <translation>Mindestwand</translation>
    </message>
    <message>
        <source>Between any two features; what the program places keeps it, and less is told of.</source>
        <translation>Zwischen je zwei Elementen; was das Programm setzt, hält es ein, und weniger wird gemeldet.</translation>
    </message>
    <message>
        <source>Sizes round up to</source>
        <translation>Maße aufgerundet auf</translation>
    </message>
    <message>
        <source>Multiples of this; 0: they are as they come out.</source>
        <translation>Vielfache hiervon; 0: wie sie sich ergeben.</translation>
    </message>
    <message>
        <source>Every second</source>
        <translation>Jede zweite</translation>
    </message>
    <message>
        <source>Cavity of a row. Turned: about the plane's normal. Turned over: the halves swap. Mirrored: the opposite-handed part. What the directions do not allow is refused.</source>
        <translation>Kavität einer Reihe. Gedreht: um die Normale der Ebene. Gewendet: die Hälften tauschen. Gespiegelt: das Gegenstück. Was die Richtungen nicht erlauben, wird abgelehnt.</translation>
    </message>
    <message>
        <source>The same</source>
        <translation>Gleich</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>Turned over</source>
        <translation>Gewendet</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Of the point of the part that stays where it is.</source>
        <translation>Des Punkts des Teils, der bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>Shrink and density</source>
        <translation>Schwindung und Dichte</translation>
    </message>
    <message>
        <source>Origin x</source>
        <translation>Ursprung x</translation>
    </message>
    <message>
        <source>Origin y</source>
        <translation>Ursprung y</translation>
    </message>
    <message>
        <source>Origin z</source>
        <translation>Ursprung z</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Of what is cast, for its mass. 0: not known.</source>
        <translation>Dessen, was gegossen wird, für seine Masse. 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>In the cavity while it is filled, for the clamp force.</source>
        <translation>In der Kavität beim Füllen, für die Schließkraft.</translation>
    </message>
    <message>
        <source>Block's density</source>
        <translation>Dichte des Blocks</translation>
    </message>
    <message>
        <source>Of what the halves are made of, for their mass. 0: not known.</source>
        <translation>Dessen, woraus die Hälften sind, für ihre Masse. 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>Gate's width</source>
        <translation>Anschnittbreite</translation>
    </message>
    <message>
        <source>Where a channel in the parting plane meets the cavity.</source>
        <translation>Wo ein Kanal in der Trennebene auf die Kavität trifft.</translation>
    </message>
    <message>
        <source>Funnel's width</source>
        <translation>Trichterbreite</translation>
    </message>
    <message>
        <source>At the block's face.</source>
        <translation>An der Blockfläche.</translation>
    </message>
    <message>
        <source>Channels' draft</source>
        <translation>Schräge der Kanäle</translation>
    </message>
    <message>
        <source>Of spouts, runners and gates; more where the directions ask for it.</source>
        <translation>Von Angüssen, Verteilern und Anschnitten; mehr, wo die Richtungen es verlangen.</translation>
    </message>
    <message>
        <source>Vents' width</source>
        <translation>Entlüftungsbreite</translation>
    </message>
    <message>
        <source>At the narrowest.</source>
        <translation>An der engsten Stelle.</translation>
    </message>
    <message>
        <source>Air that may stay</source>
        <translation>Luft, die bleiben darf</translation>
    </message>
    <message>
        <source>A place where less than this stays gets no vent.</source>
        <translation>Eine Stelle, an der weniger bleibt, bekommt keine Entlüftung.</translation>
    </message>
    <message>
        <source>Keys' width</source>
        <translation>Breite der Zapfen</translation>
    </message>
    <message>
        <source>At the parting plane.</source>
        <translation>In der Trennebene.</translation>
    </message>
    <message>
        <source>Keys' height</source>
        <translation>Höhe der Zapfen</translation>
    </message>
    <message>
        <source>Over the parting plane.</source>
        <translation>Über der Trennebene.</translation>
    </message>
    <message>
        <source>Keys' clearance</source>
        <translation>Spiel der Zapfen</translation>
    </message>
    <message>
        <source>Keys' draft</source>
        <translation>Schräge der Zapfen</translation>
    </message>
    <message>
        <source>Against both opening orders; more where the mold's draft is more.</source>
        <translation>Gegen beide Öffnungsfolgen; mehr, wo die Schräge der Form größer ist.</translation>
    </message>
    <message>
        <source>First is larger by</source>
        <translation>Erster ist größer um</translation>
    </message>
    <message>
        <source>So that the halves fit one way only.</source>
        <translation>Damit die Hälften nur auf eine Weise passen.</translation>
    </message>
    <message>
        <source>Slits' depth</source>
        <translation>Tiefe der Schlitze</translation>
    </message>
    <message>
        <source>Into the block.</source>
        <translation>In den Block hinein.</translation>
    </message>
    <message>
        <source>Slits' width</source>
        <translation>Breite der Schlitze</translation>
    </message>
    <message>
        <source>Along the block's face.</source>
        <translation>Entlang der Blockfläche.</translation>
    </message>
    <message>
        <source>Slits' height</source>
        <translation>Höhe der Schlitze</translation>
    </message>
    <message>
        <source>In each half.</source>
        <translation>In jeder Hälfte.</translation>
    </message>
    <message>
        <source>Holes' width</source>
        <translation>Breite der Löcher</translation>
    </message>
    <message>
        <source>An M6 bolt passes freely through 6.6 mm.</source>
        <translation>Eine M6-Schraube geht frei durch 6,6 mm.</translation>
    </message>
    <message>
        <source>Steel outside</source>
        <translation>Wand nach außen</translation>
    </message>
    <message>
        <source>To the block's faces.</source>
        <translation>Zu den Blockflächen.</translation>
    </message>
    <message>
        <source>Steel inside</source>
        <translation>Wand nach innen</translation>
    </message>
    <message>
        <source>To all that stands in the parting plane.</source>
        <translation>Zu allem, was in der Trennebene steht.</translation>
    </message>
    <message>
        <source>Pins' width</source>
        <translation>Breite der Stifte</translation>
    </message>
    <message>
        <source>Of the ejector pins.</source>
        <translation>Der Auswerferstifte.</translation>
    </message>
    <message>
        <source>Pins in</source>
        <translation>Stifte in</translation>
    </message>
    <message>
        <source>The half that they pass through.</source>
        <translation>Die Hälfte, durch die sie gehen.</translation>
    </message>
    <message>
        <source>Wells' width</source>
        <translation>Breite der Mulden</translation>
    </message>
    <message>
        <source>Of overflows in the parting plane.</source>
        <translation>Der Überläufe in der Trennebene.</translation>
    </message>
    <message>
        <source>Channels' width</source>
        <translation>Breite der Kanäle</translation>
    </message>
    <message>
        <source>Channels' length</source>
        <translation>Länge der Kanäle</translation>
    </message>
    <message>
        <source>Spouts, runners, gates</source>
        <translation>Angüsse, Verteiler, Anschnitte</translation>
    </message>
    <message>
        <source>Up while filled</source>
        <translation>Oben beim Füllen</translation>
    </message>
    <message>
        <source>As a turn of the cast about the plane's normal; automatic: of four the one that keeps the least air.</source>
        <translation>Als Drehung des Gusses um die Normale der Ebene; automatisch: von vieren die, bei der am wenigsten Luft bleibt.</translation>
    </message>
    <message>
        <source>Tilt while filled</source>
        <translation>Neigung beim Füllen</translation>
    </message>
    <message>
        <source>Engraved in the back of each half; | between lines. {part}, {number}, {revision}, {half} and {shrink} are replaced; auto: all there is of them. Empty: none.</source>
        <translation>In den Rücken jeder Hälfte graviert; | zwischen Zeilen. {part}, {number}, {revision}, {half} und {shrink} werden ersetzt; auto: alles, was es davon gibt. Leer: keine.</translation>
    </message>
</context>
<context>
    <name>MoldPlacing</name>
    <message>
        <source>the block&apos;s face</source>
        <translation>Blockfläche</translation>
    </message>
    <message>
        <source>cavity %1</source>
        <translation>Kavität %1</translation>
    </message>
    <message>
        <source>a runner</source>
        <translation>Verteilerkanal</translation>
    </message>
    <message>
        <source>a gate</source>
        <translation>Anschnitt</translation>
    </message>
    <message>
        <source>spout %1</source>
        <translation>Anguss %1</translation>
    </message>
    <message>
        <source>vent %1</source>
        <translation>Entlüftung %1</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>Zapfen %1</translation>
    </message>
    <message>
        <source>wedge slit %1</source>
        <translation>Keilschlitz %1</translation>
    </message>
    <message>
        <source>bolt hole %1</source>
        <translation>Schraubenloch %1</translation>
    </message>
    <message>
        <source>ejector hole %1</source>
        <translation>Auswerferloch %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Place %1 automatically</source>
        <translation>%1 automatisch platzieren</translation>
    </message>
    <message>
        <source>Place all automatically</source>
        <translation>Alle automatisch platzieren</translation>
    </message>
    <message>
        <source>Spout %1</source>
        <translation>Anguss %1</translation>
    </message>
    <message>
        <source>Vent %1</source>
        <translation>Entlüftung %1</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>Zapfen %1</translation>
    </message>
    <message>
        <source>Wedge slit %1</source>
        <translation>Keilschlitz %1</translation>
    </message>
    <message>
        <source>Bolt hole %1</source>
        <translation>Schraubenloch %1</translation>
    </message>
    <message>
        <source>Ejector hole %1</source>
        <translation>Auswerferloch %1</translation>
    </message>
    <message>
        <source>No steel to %1, %2 mm asked for</source>
        <translation>Kein Stahl bis %1, %2 mm verlangt</translation>
    </message>
    <message>
        <source>%1 mm of steel to %2, %3 asked for</source>
        <translation>%1 mm Stahl bis %2, %3 verlangt</translation>
    </message>
    <message>
        <source>%1 mm of steel to %2</source>
        <translation>%1 mm Stahl bis %2</translation>
    </message>
    <message>
        <source>overflow %1</source>
        <translation>Überlauf %1</translation>
    </message>
    <message>
        <source>the channel of overflow %1</source>
        <translation>dem Kanal von Überlauf %1</translation>
    </message>
    <message>
        <source>Overflow %1</source>
        <translation>Überlauf %1</translation>
    </message>
    <message>
        <source>Insert pocket %1</source>
        <translation>Einlegertasche %1</translation>
    </message>
    <message>
        <source>insert pocket %1</source>
        <translation>Einlegertasche %1</translation>
    </message>
    <message>
        <source>the plaque on half %1</source>
        <translation>dem Schild auf Hälfte %1</translation>
    </message>
    <message>
        <source>Place %1 features automatically</source>
        <translation>%1 Elemente automatisch platzieren</translation>
    </message>
    <message>
        <source>block's face</source>
        <translation>Blockfläche</translation>
    </message>
</context>
<context>
    <name>ObstructionWords</name>
    <message>
        <source>Pocket of air</source>
        <translation>Lufttasche</translation>
    </message>
    <message>
        <source>Closed piece</source>
        <translation>Geschlossenes Stück</translation>
    </message>
    <message>
        <source>Handle or arch</source>
        <translation>Henkel oder Bogen</translation>
    </message>
    <message>
        <source>Linked pieces</source>
        <translation>Verkettete Stücke</translation>
    </message>
    <message>
        <source>Steep faces</source>
        <translation>Steile Flächen</translation>
    </message>
</context>
<context>
    <name>Pictures</name>
    <message>
        <source>Pictures cannot be drawn on this machine: OpenGL {0}.</source>
        <translation>Auf diesem Rechner lassen sich keine Bilder zeichnen: OpenGL {0}.</translation>
    </message>
</context>
<context>
    <name>PinPages</name>
    <message>
        <source>Suggested</source>
        <translation>Vorgeschlagen</translation>
    </message>
    <message>
        <source>Ends of limbs, where limbs meet, and points along the body.</source>
        <translation>Enden von Gliedern, wo Glieder sich treffen, und Punkte längs des Körpers.</translation>
    </message>
    <message>
        <source>Shown at most</source>
        <translation>Höchstens gezeigt</translation>
    </message>
    <message>
        <source>The best ones at this plane; those taken are no longer shown.</source>
        <translation>Die besten bei dieser Ebene; angenommene werden nicht mehr gezeigt.</translation>
    </message>
    <message>
        <source>Ends of limbs</source>
        <translation>Enden von Gliedern</translation>
    </message>
    <message>
        <source>Click a faint ring in the view to take it.</source>
        <translation>Ein Klick auf einen blassen Ring im Bild nimmt ihn an.</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Heftpunkte</translation>
    </message>
    <message>
        <source>Hold points of the part on the parting plane.</source>
        <translation>Halten Punkte des Teils auf der Trennebene.</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Von Hand gesetzt</translation>
    </message>
    <message>
        <source>No pins yet. Where limbs curl, pins at their ends unroll them.</source>
        <translation>Noch keine Heftpunkte. Wo Glieder sich krümmen, rollen Heftpunkte an ihren Enden sie auf.</translation>
    </message>
    <message>
        <source>Farthest from the plane</source>
        <translation>Am weitesten von der Ebene</translation>
    </message>
    <message>
        <source>All pins</source>
        <translation>Alle Heftpunkte</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Suggested pins</source>
        <translation>Vorgeschlagen</translation>
    </message>
    <message>
        <source>Place in the part</source>
        <translation>Stelle im Teil</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>To the plane</source>
        <translation>Zur Ebene</translation>
    </message>
    <message>
        <source>How far a run has to draw it, along the plane&apos;s normal.</source>
        <translation>Wie weit ein Lauf ihn ziehen muss, längs der Normalen der Ebene.</translation>
    </message>
    <message>
        <source>%1 to the plane</source>
        <translation>%1 zur Ebene</translation>
    </message>
    <message>
        <source>%1 pins</source>
        <translation>%1 Heftpunkte</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Move %1 pins</source>
        <translation>%1 Heftpunkte verschieben</translation>
    </message>
</context>
<context>
    <name>Presentation</name>
    <message>
        <source>Running, step %1</source>
        <translation>Läuft, Schritt %1</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Not started</source>
        <translation>Steht aus</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Waits for Deform</source>
        <translation>Wartet auf Verformen</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Wird geprüft</translation>
    </message>
    <message>
        <source>Proved at %1</source>
        <translation>Bewiesen bei %1</translation>
    </message>
    <message>
        <source>Not proved</source>
        <translation>Nicht bewiesen</translation>
    </message>
    <message>
        <source>Proved</source>
        <translation>Bewiesen</translation>
    </message>
    <message>
        <source>%1 to level</source>
        <translation>%1 geneigt</translation>
    </message>
    <message>
        <source>%1, closed</source>
        <translation>%1, geschlossen</translation>
    </message>
    <message>
        <source>Not chosen yet</source>
        <translation>Noch nicht gewählt</translation>
    </message>
    <message>
        <source>Found by the run</source>
        <translation>Vom Lauf gefunden</translation>
    </message>
    <message>
        <source>Number %1 of %2</source>
        <translation>Nummer %1 von %2</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>Druckbereit</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 Flächen</translation>
    </message>
    <message>
        <source>Parting plane</source>
        <translation>Trennebene</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>Richtung %1</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Verformen</translation>
    </message>
    <message>
        <source>Cast</source>
        <translation>Guss</translation>
    </message>
    <message>
        <source>Mold</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>No part open</source>
        <translation>Kein Teil offen</translation>
    </message>
    <message>
        <source>Open a mesh or a sample</source>
        <translation>Ein Netz oder Beispiel öffnen</translation>
    </message>
    <message>
        <source>Castable and opens</source>
        <translation>Gießbar und öffnet sich</translation>
    </message>
    <message>
        <source>Cast and halves proved at %1 draft</source>
        <translation>Guss und Hälften bewiesen bei %1 Schräge</translation>
    </message>
    <message>
        <source>Castable</source>
        <translation>Gießbar</translation>
    </message>
    <message>
        <source>Proved at %1 draft, %2 required</source>
        <translation>Bewiesen bei %1 Schräge, %2 verlangt</translation>
    </message>
    <message>
        <source>Not castable yet</source>
        <translation>Noch nicht gießbar</translation>
    </message>
    <message>
        <source>Measuring the draft</source>
        <translation>Die Schräge wird gemessen</translation>
    </message>
    <message>
        <source>%1 of the surface below %2</source>
        <translation>%1 der Oberfläche unter %2</translation>
    </message>
    <message>
        <source>No undercut seen; Run proves it</source>
        <translation>Kein Hinterschnitt zu sehen; Start beweist es</translation>
    </message>
    <message>
        <source>Step %1, live</source>
        <translation>Schritt %1, live</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Beginnt</translation>
    </message>
    <message>
        <source>Part as opened</source>
        <translation>Teil wie geöffnet</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Step %1, paused</source>
        <translation>Schritt %1, angehalten</translation>
    </message>
    <message>
        <source>Obstructed</source>
        <translation>Versperrt</translation>
    </message>
    <message>
        <source>Cannot be cast yet</source>
        <translation>So nicht gießbar</translation>
    </message>
    <message>
        <source>One obstruction at this plane</source>
        <translation>Ein Hindernis an dieser Ebene</translation>
    </message>
    <message>
        <source>%1 obstructions at this plane</source>
        <translation>%1 Hindernisse an dieser Ebene</translation>
    </message>
    <message>
        <source>will be filled</source>
        <translation>wird gefüllt</translation>
    </message>
    <message>
        <source>1 pin</source>
        <translation>1 Heftpunkt</translation>
    </message>
    <message>
        <source>%1 pins</source>
        <translation>%1 Heftpunkte</translation>
    </message>
    <message>
        <source>Ready to run</source>
        <translation>Bereit zum Start</translation>
    </message>
    <message>
        <source>Half %1</source>
        <translation>Hälfte %1</translation>
    </message>
    <message>
        <source>1 region</source>
        <translation>1 Region</translation>
    </message>
    <message>
        <source>%1 regions</source>
        <translation>%1 Regionen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Step %1 of the last run</source>
        <translation>Schritt %1 des letzten Laufs</translation>
    </message>
    <message>
        <source>Step %1 in view</source>
        <translation>Schritt %1 gezeigt</translation>
    </message>
    <message>
        <source>As read</source>
        <translation>Wie gelesen</translation>
    </message>
    <message>
        <source>Mold, proved</source>
        <translation>Form, bewiesen</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>The project file could not be put together.</source>
        <translation>Die Projektdatei ließ sich nicht zusammenstellen.</translation>
    </message>
    <message>
        <source>The evaluation was cancelled.</source>
        <translation>Die Auswertung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>{0} is damaged: its part {1} is missing or cannot be read. Open an older copy of the project.</source>
        <translation>{0} ist beschädigt: der Bestandteil {1} fehlt oder ist unlesbar. Eine ältere Kopie des Projekts öffnen.</translation>
    </message>
    <message>
        <source>{0} was saved by a newer Moldwright. A program that reads format {1} is needed; this one reads up to {2}.</source>
        <translation>{0} wurde von einem neueren Moldwright gespeichert. Nötig ist ein Programm für Format {1}; dieses liest bis {2}.</translation>
    </message>
    <message>
        <source>{0} is not a Moldwright project.</source>
        <translation>{0} ist kein Moldwright-Projekt.</translation>
    </message>
    <message>
        <source>{0} cannot be opened: {1}.</source>
        <translation>{0} lässt sich nicht öffnen: {1}.</translation>
    </message>
    <message>
        <source>{0} is too large for a project file.</source>
        <translation>{0} ist zu groß für eine Projektdatei.</translation>
    </message>
    <message>
        <source>{0} cannot be read.</source>
        <translation>{0} lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>{0} has no variant {1}. It has: {2}.</source>
        <translation>{0} hat keine Variante {1}. Es hat: {2}.</translation>
    </message>
    <message>
        <source>No folder can be made in {0}.</source>
        <translation>In {0} lässt sich kein Ordner anlegen.</translation>
    </message>
    <message>
        <source>{0} holds no finished cast. Run its design to the end and save it first.</source>
        <translation>{0} enthält keinen fertigen Guss. Lassen Sie dort zuerst die Verformung zu Ende laufen und speichern Sie.</translation>
    </message>
</context>
<context>
    <name>PropertyPages</name>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Draft required</source>
        <translation>Verlangte Schräge</translation>
    </message>
    <message>
        <source>The least angle between the surface and the direction its half leaves in.</source>
        <translation>Der kleinste Winkel zwischen der Oberfläche und der Richtung, in der ihre Hälfte abgezogen wird.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Longest side</source>
        <translation>Längste Seite</translation>
    </message>
    <message>
        <source>Scales the whole part.</source>
        <translation>Skaliert das ganze Teil.</translation>
    </message>
    <message>
        <source>Place of its middle</source>
        <translation>Lage der Mitte</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Größe, mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Parting plane</source>
        <translation>Trennebene</translation>
    </message>
    <message>
        <source>Drag its grips in the view, or type here.</source>
        <translation>Die Griffe in der Ansicht ziehen oder hier eingeben.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Distance of the plane from the origin along its normal.</source>
        <translation>Abstand der Ebene vom Ursprung entlang ihrer Normalen.</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>While it runs</source>
        <translation>Im Lauf</translation>
    </message>
    <message>
        <source>Best for the plane</source>
        <translation>Beste zur Ebene</translation>
    </message>
    <message>
        <source>Along the normal</source>
        <translation>Entlang der Normalen</translation>
    </message>
    <message>
        <source>As they are</source>
        <translation>Wie sie sind</translation>
    </message>
    <message>
        <source>Tilt limit</source>
        <translation>Größte Neigung</translation>
    </message>
    <message>
        <source>How far a direction may lean from the plane&apos;s normal.</source>
        <translation>Wie weit eine Richtung von der Ebenennormalen abweichen darf.</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>Kleinste Schräge</translation>
    </message>
    <message>
        <source>Area below</source>
        <translation>Fläche darunter</translation>
    </message>
    <message>
        <source>Direction 1</source>
        <translation>Richtung 1</translation>
    </message>
    <message>
        <source>Angle to the plane&apos;s normal.</source>
        <translation>Winkel zur Ebenennormalen.</translation>
    </message>
    <message>
        <source>Direction 2</source>
        <translation>Richtung 2</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Verformen</translation>
    </message>
    <message>
        <source>Bends the part until both halves come off.</source>
        <translation>Biegt das Teil, bis sich beide Hälften abziehen lassen.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the shape is bent.</source>
        <translation>Wie die Form gebogen wird.</translation>
    </message>
    <message>
        <source>Elastic, then finish</source>
        <translation>Elastisch</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>Wie im Aufsatz</translation>
    </message>
    <message>
        <source>How the removal directions are chosen.</source>
        <translation>Wie die Entformungsrichtungen gewählt werden.</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Mittlerer Abstand</translation>
    </message>
    <message>
        <source>To the part, over its diagonal, after the best rigid fit.</source>
        <translation>Zum Teil, bezogen auf seine Diagonale, nach bester starrer Einpassung.</translation>
    </message>
    <message>
        <source>Cast</source>
        <translation>Guss</translation>
    </message>
    <message>
        <source>What will come out of the mold.</source>
        <translation>Was aus der Form kommen wird.</translation>
    </message>
    <message>
        <source>Castability</source>
        <translation>Gießbarkeit</translation>
    </message>
    <message>
        <source>Self-intersections</source>
        <translation>Selbstschnitte</translation>
    </message>
    <message>
        <source>Parting curve</source>
        <translation>Trennlinie</translation>
    </message>
    <message>
        <source>Proved</source>
        <translation>Bewiesen</translation>
    </message>
    <message>
        <source>Kept from the part</source>
        <translation>Vom Teil erhalten</translation>
    </message>
    <message>
        <source>Over the part&apos;s diagonal, after the best rigid fit.</source>
        <translation>Bezogen auf die Diagonale des Teils, nach bester starrer Einpassung.</translation>
    </message>
    <message>
        <source>Shortest limb</source>
        <translation>Kürzestes Glied</translation>
    </message>
    <message>
        <source>Length, cast over part.</source>
        <translation>Länge, Guss zu Teil.</translation>
    </message>
    <message>
        <source>no limbs</source>
        <translation>keine Glieder</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>einfach</translation>
    </message>
    <message>
        <source>crosses itself</source>
        <translation>kreuzt sich</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Scale the part</source>
        <translation>Teil skalieren</translation>
    </message>
    <message>
        <source>Move the part</source>
        <translation>Teil verschieben</translation>
    </message>
    <message>
        <source>Move the plane</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>Change the deformation&apos;s settings</source>
        <translation>Einstellungen der Verformung ändern</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>Richtung %1</translation>
    </message>
    <message>
        <source>Drag the arrow&apos;s tip in the view, or type here.</source>
        <translation>Die Pfeilspitze in der Ansicht ziehen oder hier eingeben.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Leans towards</source>
        <translation>Neigt sich nach</translation>
    </message>
    <message>
        <source>The way it leans, counted in the plane. Without tilt it says nothing.</source>
        <translation>Wohin sie sich neigt, in der Ebene gezählt. Ohne Neigung sagt es nichts.</translation>
    </message>
    <message>
        <source>X, Y, Z</source>
        <translation>X, Y, Z</translation>
    </message>
    <message>
        <source>Turn direction %1</source>
        <translation>Richtung %1 drehen</translation>
    </message>
    <message>
        <source>Where bending fails</source>
        <translation>Was sich nicht biegt</translation>
    </message>
    <message>
        <source>What becomes of places that no bending frees: told as an obstruction, or filled.</source>
        <translation>Was mit Stellen geschieht, die kein Biegen löst: als Hindernis genannt oder gefüllt.</translation>
    </message>
    <message>
        <source>Leave as it is</source>
        <translation>Lassen, wie es ist</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>X, Y, Z, mm</source>
        <translation>X, Y, Z, mm</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>What helps</source>
        <translation>Was hilft</translation>
    </message>
    <message>
        <source>Filled</source>
        <translation>Gefüllt</translation>
    </message>
    <message>
        <source>What was filled in where no bending helps, over the part&apos;s volume.</source>
        <translation>Was gefüllt wurde, wo kein Biegen hilft, im Verhältnis zum Volumen des Teils.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>The axis that the press pulls along: both directions keep to it.</source>
        <translation>Die Achse, in der die Presse zieht: beide Richtungen halten sich an sie.</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Beliebig</translation>
    </message>
    <message>
        <source>That of direction 1</source>
        <translation>Die von Richtung 1</translation>
    </message>
    <message>
        <source>Off the axis</source>
        <translation>Von der Achse ab</translation>
    </message>
    <message>
        <source>How far a direction may lean from the axis; 0 holds it there.</source>
        <translation>Wie weit eine Richtung von der Achse abweichen darf; 0 hält sie fest.</translation>
    </message>
    <message>
        <source>%1 below %2</source>
        <translation>%1 unter %2</translation>
    </message>
    <message>
        <source>Worst %1</source>
        <translation>Kleinste %1</translation>
    </message>
    <message>
        <source>Directions tilted by %1 and %2, %3 of the volume on the smaller side</source>
        <translation>Richtungen geneigt um %1 und %2, %3 des Volumens auf der kleineren Seite</translation>
    </message>
    <message>
        <source>Planes found, best first</source>
        <translation>Gefundene Ebenen, beste zuerst</translation>
    </message>
    <message>
        <source>Sharpest crease</source>
        <translation>Schärfster Knick</translation>
    </message>
    <message>
        <source>At the parting line, where the directions are not parallel.</source>
        <translation>An der Trennlinie, wo die Richtungen nicht parallel sind.</translation>
    </message>
    <message>
        <source>While it bends</source>
        <translation>Beim Verformen</translation>
    </message>
    <message>
        <source>Whether directions that are best for the plane are sought anew as the shape bends. The paper&apos;s method always does that.</source>
        <translation>Ob die besten Richtungen zur Ebene neu gesucht werden, während sich die Form verformt. Das veröffentlichte Verfahren tut das immer.</translation>
    </message>
    <message>
        <source>They stay</source>
        <translation>Sie bleiben</translation>
    </message>
    <message>
        <source>They follow the shape</source>
        <translation>Sie folgen der Form</translation>
    </message>
    <message>
        <source>Smoothing γ</source>
        <translation>Glättung γ</translation>
    </message>
    <message>
        <source>How much neighbours turn alike in the paper&apos;s method.</source>
        <translation>Wie sehr sich Nachbarn im veröffentlichten Verfahren gleich drehen.</translation>
    </message>
    <message>
        <source>Change the mold</source>
        <translation>Form ändern</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Schriftfeld</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Of the part.</source>
        <translation>Des Teils.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>As its drawing has it.</source>
        <translation>Wie auf seiner Zeichnung.</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>Revision</translation>
    </message>
    <message>
        <source>Change the title</source>
        <translation>Schriftfeld ändern</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Goat head</source>
        <translation>Ziegenkopf</translation>
    </message>
    <message>
        <source>Curled horns, an eye worth keeping</source>
        <translation>Gewundene Hörner, wacher Blick</translation>
    </message>
    <message>
        <source>Sitting rabbit</source>
        <translation>Sitzender Hase</translation>
    </message>
    <message>
        <source>Ears that lean apart</source>
        <translation>Ohren, die auseinanderstehen</translation>
    </message>
    <message>
        <source>Standing goat</source>
        <translation>Stehende Ziege</translation>
    </message>
    <message>
        <source>Four legs, two horns, one plane</source>
        <translation>Vier Beine, zwei Hörner, eine Ebene</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Which plane suits the fingers?</source>
        <translation>Welche Ebene passt zu den Fingern?</translation>
    </message>
    <message>
        <source>Fish</source>
        <translation>Fisch</translation>
    </message>
    <message>
        <source>Keep the curve of the tail fin</source>
        <translation>Schwung in der Schwanzflosse</translation>
    </message>
    <message>
        <source>Bent beam</source>
        <translation>Gebogener Träger</translation>
    </message>
    <message>
        <source>Sharp corners, exact flanges</source>
        <translation>Scharfe Ecken, genaue Flansche</translation>
    </message>
    <message>
        <source>Door knob</source>
        <translation>Türknauf</translation>
    </message>
    <message>
        <source>A neck that locks in any mold</source>
        <translation>Ein Hals, der in jeder Form klemmt</translation>
    </message>
    <message>
        <source>Praline</source>
        <translation>Praline</translation>
    </message>
    <message>
        <source>Flat back, castable as it is</source>
        <translation>Flacher Rücken, gießbar, wie sie ist</translation>
    </message>
</context>
<context>
    <name>UndercutPages</name>
    <message>
        <source>Undercut %1</source>
        <translation>Hinterschnitt %1</translation>
    </message>
    <message>
        <source>fill, %1</source>
        <translation>füllen, %1</translation>
    </message>
    <message>
        <source>bend, %1</source>
        <translation>biegen, %1</translation>
    </message>
    <message>
        <source>Undercuts</source>
        <translation>Hinterschnitte</translation>
    </message>
    <message>
        <source>What a half cannot leave at this plane, region by region.</source>
        <translation>Woraus sich an dieser Ebene keine Hälfte löst, Stelle für Stelle.</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <source>Not to be bent</source>
        <translation>Nicht zu biegen</translation>
    </message>
    <message>
        <source>Regions that no bending frees.</source>
        <translation>Stellen, die kein Biegen befreit.</translation>
    </message>
    <message>
        <source>To fill all</source>
        <translation>Alle zu füllen</translation>
    </message>
    <message>
        <source>No bending frees it: have it filled, or move the plane.</source>
        <translation>Kein Biegen befreit ihn: füllen lassen oder die Ebene verschieben.</translation>
    </message>
    <message>
        <source>Bending frees it. Filled, what lies about it stays as it is.</source>
        <translation>Biegen befreit ihn. Gefüllt bleibt, was um ihn liegt, wie es ist.</translation>
    </message>
    <message>
        <source>Filling it joins pieces of the part that are apart.</source>
        <translation>Füllen verbindet Stücke des Teils, die getrennt sind.</translation>
    </message>
    <message>
        <source>What becomes of it</source>
        <translation>Was daraus wird</translation>
    </message>
    <message>
        <source>Treatment</source>
        <translation>Behandlung</translation>
    </message>
    <message>
        <source>By the rule: as the page of Deform says for all.</source>
        <translation>Nach der Regel: wie es die Seite Verformen für alle sagt.</translation>
    </message>
    <message>
        <source>By the rule</source>
        <translation>Nach der Regel</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Biegen</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>X, Y, Z, mm</source>
        <translation>X, Y, Z, mm</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>To fill</source>
        <translation>Zu füllen</translation>
    </message>
    <message>
        <source>What filling it takes, over the part&apos;s volume.</source>
        <translation>Was das Füllen braucht, bezogen auf das Volumen des Teils.</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
</context>
<context>
    <name>VariantPages</name>
    <message>
        <source>not run</source>
        <translation>nicht gerechnet</translation>
    </message>
    <message>
        <source>not castable</source>
        <translation>nicht gießbar</translation>
    </message>
    <message>
        <source>Castable</source>
        <translation>Gießbar</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>Kleinste Schräge</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Farthest, mm</source>
        <translation>Größte Abw., mm</translation>
    </message>
    <message>
        <source>RMS, mm</source>
        <translation>RMS, mm</translation>
    </message>
    <message>
        <source>Filled, cm³</source>
        <translation>Gefüllt, cm³</translation>
    </message>
    <message>
        <source>Block, mm</source>
        <translation>Block, mm</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>one</source>
        <translation>eine</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>Several designs of this part in one project.</source>
        <translation>Mehrere Entwürfe dieses Teils in einem Projekt.</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Distances are to the part, after the best rigid fit; the bold one is the current one, which all other pages show.</source>
        <translation>Abstände sind die zum Teil, nach bester starrer Lage; die fette Variante ist die aktuelle, die alle anderen Seiten zeigen.</translation>
    </message>
    <message>
        <source>One design so far. Duplicate it to try another plane, other pins or weights, and to compare both.</source>
        <translation>Bisher ein Entwurf. Duplizieren Sie ihn, um eine andere Ebene, andere Heftpunkte oder Gewichte zu versuchen und beide zu vergleichen.</translation>
    </message>
    <message>
        <source>current, %1</source>
        <translation>aktuell, %1</translation>
    </message>
</context>
<context>
    <name>design</name>
    <message>
        <source>Move the plane by {0} mm towards side {1}: nothing is in the way there.</source>
        <translation>Die Ebene um {0} mm zur Seite {1} hin verschieben: dort steht nichts im Weg.</translation>
    </message>
    <message>
        <source>Part it square to ({0}, {1}, {2}), {3} mm from the origin, instead: nothing is in the way there.</source>
        <translation>Stattdessen quer zu ({0}, {1}, {2}) teilen, {3} mm vom Ursprung: dort steht nichts im Weg.</translation>
    </message>
    <message>
        <source>Have it joined to the piece beside it: that fills in {0} cm³, {1} % of the part.</source>
        <translation>Mit dem Stück daneben verbinden lassen: das füllt {0} cm³ auf, {1} % des Teils.</translation>
    </message>
    <message>
        <source>Fill it: that takes {0} cm³, {1} % of the part.</source>
        <translation>Es füllen: dazu braucht es {0} cm³, {1} % des Teils.</translation>
    </message>
    <message>
        <source>Pin the point {0} to the plane, {1} mm away, so that the plane runs through it.</source>
        <translation>Den Punkt {0} an die {1} mm entfernte Ebene heften, so dass sie durch ihn geht.</translation>
    </message>
    <message>
        <source>The pins draw the part through itself at ({0}, {1}, {2}). Leave one of them out, or give another plane.</source>
        <translation>Die Stifte ziehen das Teil bei ({0}, {1}, {2}) durch sich selbst hindurch. Einen davon weglassen oder eine andere Ebene angeben.</translation>
    </message>
    <message>
        <source>A pinned point of the surface could not be made a point of the parting line. Pin a point inside the part instead.</source>
        <translation>Ein angehefteter Punkt der Oberfläche ließ sich nicht zu einem Punkt der Trennlinie machen. Stattdessen einen Punkt im Inneren des Teils anheften.</translation>
    </message>
    <message>
        <source>The design was cancelled.</source>
        <translation>Der Entwurf wurde abgebrochen.</translation>
    </message>
    <message>
        <source>A closed piece of {2} mm lies wholly on side {0}, near {1}: it never meets the parting plane. Move the plane through it.</source>
        <translation>Ein geschlossenes Stück von {2} mm liegt ganz auf Seite {0}, nahe {1}: es trifft die Trennebene nie. Die Ebene hindurchlegen.</translation>
    </message>
    <message>
        <source>A handle of {2} mm stands on side {0}, near {1}: the mold cannot leave its hole. Move the plane through the hole, or fill it.</source>
        <translation>Ein Henkel von {2} mm steht auf Seite {0}, nahe {1}: die Form kommt nicht aus seinem Loch. Die Ebene durch das Loch legen oder es füllen.</translation>
    </message>
    <message>
        <source>An arch of {2} mm spans a gap on side {0}, near {1}: the mold under it cannot leave. Move the plane, or fill the gap.</source>
        <translation>Ein Bogen von {2} mm überspannt eine Lücke auf Seite {0}, nahe {1}: die Form darunter kommt nicht heraus. Die Ebene verlegen oder die Lücke füllen.</translation>
    </message>
    <message>
        <source>A pocket of air of {2} mm lies on side {0}, near {1}: the mold in it cannot leave. Move the plane, or fill the pocket.</source>
        <translation>Eine Lufttasche von {2} mm liegt auf Seite {0}, nahe {1}: die Form darin kommt nicht heraus. Die Ebene verlegen oder die Tasche füllen.</translation>
    </message>
    <message>
        <source>The parting line could not be inserted without the surface crossing itself.</source>
        <translation>Die Trennlinie ließ sich nicht einfügen, ohne dass die Oberfläche sich selbst kreuzt.</translation>
    </message>
    <message>
        <source>Filling would join pieces of the part that are apart. Allow it, take them apart further, or give another plane.</source>
        <translation>Das Füllen würde getrennte Stücke des Teils verbinden. Das erlauben, sie weiter auseinanderrücken oder eine andere Ebene angeben.</translation>
    </message>
    <message>
        <source>A piece of {2} mm spans another piece on side {0}, near {1}: they hang in one another, and no half can leave between them. Take them apart, or have them merged.</source>
        <translation>Ein Stück von {2} mm überspannt auf Seite {0}, nahe {1}, ein anderes: sie hängen ineinander, und keine Hälfte kommt zwischen ihnen heraus. Sie trennen oder vereinigen lassen.</translation>
    </message>
    <message>
        <source>The undercut near {0} is to be bent, and no bending frees it. Have it filled, or move the plane.</source>
        <translation>Der Hinterschnitt bei {0} soll gebogen werden, und kein Biegen befreit ihn. Füllen lassen oder die Ebene verschieben.</translation>
    </message>
    <message>
        <source>Undercuts were chosen to be filled or bent, and no plane was given: which undercuts there are depends on it. Give a plane too.</source>
        <translation>Es wurde gewählt, welche Hinterschnitte gefüllt oder gebogen werden, aber keine Ebene: Welche es gibt, hängt von ihr ab. Auch eine Ebene angeben.</translation>
    </message>
    <message>
        <source>No direction within {0}° of the axis leaves the plane within {1}° of its normal. Turn the plane towards the axis, or allow more.</source>
        <translation>Keine Richtung, die höchstens {0}° von der Achse abweicht, verlässt die Ebene höchstens {1}° neben ihrer Normalen. Die Ebene zur Achse drehen oder mehr zulassen.</translation>
    </message>
    <message>
        <source>The shape that the run had reached could not be parted at this plane: bending began anew with the part.</source>
        <translation>Die erreichte Form ließ sich an dieser Ebene nicht teilen: Die Verformung begann neu mit dem Teil.</translation>
    </message>
</context>
<context>
    <name>exchange</name>
    <message>
        <source>The folder {0} could not be made: {1}.</source>
        <translation>Der Ordner {0} ließ sich nicht anlegen: {1}.</translation>
    </message>
    <message>
        <source>{0} could not be written: {1}.</source>
        <translation>{0} ließ sich nicht schreiben: {1}.</translation>
    </message>
    <message>
        <source>There is no file {0}.</source>
        <translation>Es gibt keine Datei {0}.</translation>
    </message>
    <message>
        <source>{0} is a folder, not a mesh file.</source>
        <translation>{0} ist ein Ordner, keine Netzdatei.</translation>
    </message>
    <message>
        <source>{0} is not a plain file.</source>
        <translation>{0} ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>{0} could not be read: {1}.</source>
        <translation>{0} ließ sich nicht lesen: {1}.</translation>
    </message>
    <message>
        <source>The worker program&apos;s answer is incomplete.</source>
        <translation>Die Antwort des Arbeiterprogramms ist unvollständig.</translation>
    </message>
    <message>
        <source>{0} is an empty file.</source>
        <translation>{0} ist eine leere Datei.</translation>
    </message>
    <message>
        <source>{0} is in no format that Moldwright reads: STL, OBJ, PLY or OFF.</source>
        <translation>{0} hat kein Format, das Moldwright liest: STL, OBJ, PLY oder OFF.</translation>
    </message>
    <message>
        <source>{0}, line {1}: “{2}” is not understood in the header of a PLY file of version 1.0.</source>
        <translation>{0}, Zeile {1}: „{2}“ ist im Kopf einer PLY-Datei der Version 1.0 nicht verständlich.</translation>
    </message>
    <message>
        <source>{0} ends within its header: the line “end_header” is missing.</source>
        <translation>{0} endet in seinem Kopf: die Zeile „end_header“ fehlt.</translation>
    </message>
    <message>
        <source>{0}, {1}: a face&apos;s corner is “{2}”, not the number of a point from 1 on.</source>
        <translation>{0}, {1}: eine Flächenecke ist „{2}“, nicht die Nummer eines Punkts ab 1.</translation>
    </message>
    <message>
        <source>{0} is not an OBJ file: it holds binary data.</source>
        <translation>{0} ist keine OBJ-Datei: sie enthält Binärdaten.</translation>
    </message>
    <message>
        <source>{0} ends too early: after {1} of {2} points and {3} of {4} faces.</source>
        <translation>{0} endet zu früh: nach {1} von {2} Punkten und {3} von {4} Flächen.</translation>
    </message>
    <message>
        <source>{0} holds points of other than three dimensions.</source>
        <translation>{0} enthält Punkte mit anderer Dimension als drei.</translation>
    </message>
    <message>
        <source>{0} is a binary OFF file; only OFF in text is read.</source>
        <translation>{0} ist eine binäre OFF-Datei; nur OFF als Text wird gelesen.</translation>
    </message>
    <message>
        <source>{0}, {1}: here should stand how many points and faces there are, not “{2}”.</source>
        <translation>{0}, {1}: hier sollte stehen, wie viele Punkte und Flächen es gibt, nicht „{2}“.</translation>
    </message>
    <message>
        <source>{0}, {1}: a face of {2} corners needs as many numbers of points. The file may be cut off.</source>
        <translation>{0}, {1}: eine Fläche mit {2} Ecken braucht ebenso viele Punktnummern. Die Datei ist vielleicht abgeschnitten.</translation>
    </message>
    <message>
        <source>What follows the last face was ignored.</source>
        <translation>Was auf die letzte Fläche folgt, wurde übergangen.</translation>
    </message>
    <message>
        <source>{0} spare bytes at the end were ignored.</source>
        <translation>{0} überzählige Bytes am Ende wurden übergangen.</translation>
    </message>
    <message>
        <source>{0} holds its surface as tristrips (strips of triangles). Save it with plain faces.</source>
        <translation>{0} enthält die Oberfläche als Dreiecksstreifen (tristrips). Mit einfachen Flächen speichern.</translation>
    </message>
    <message>
        <source>{0} announces {1} times “{2}” but is too short to hold them.</source>
        <translation>{0} kündigt {1}-mal „{2}“ an, ist dafür aber zu kurz.</translation>
    </message>
    <message>
        <source>{0}, {1}: a number is missing here, not finite, or not a number. The file may be cut off.</source>
        <translation>{0}, {1}: hier fehlt eine Zahl, ist nicht endlich oder keine Zahl. Die Datei ist vielleicht abgeschnitten.</translation>
    </message>
    <message>
        <source>{0} is not a PLY file: it does not begin with “ply”.</source>
        <translation>{0} ist keine PLY-Datei: sie beginnt nicht mit „ply“.</translation>
    </message>
    <message>
        <source>{0} announces {1} triangles but holds {2}. It is damaged, or not an STL file.</source>
        <translation>{0} kündigt {1} Dreiecke an, enthält aber {2}. Sie ist beschädigt oder keine STL-Datei.</translation>
    </message>
    <message>
        <source>{0}, {1}: a facet ends too early. The file may be cut off.</source>
        <translation>{0}, {1}: eine Facette endet zu früh. Die Datei ist vielleicht abgeschnitten.</translation>
    </message>
    <message>
        <source>{0} is not an STL file: it is text that does not begin with “solid”.</source>
        <translation>{0} ist keine STL-Datei: der Text beginnt nicht mit „solid“.</translation>
    </message>
    <message>
        <source>{0} is {1} bytes long, too short for an STL file.</source>
        <translation>{0} ist {1} Bytes lang, zu kurz für eine STL-Datei.</translation>
    </message>
    <message>
        <source>{0}, {1}: a point needs three numbers, but the line ends early.</source>
        <translation>{0}, {1}: ein Punkt braucht drei Zahlen, die Zeile endet aber früher.</translation>
    </message>
    <message>
        <source>{0}, {1}: a point needs three finite numbers, but here stands “{2}”.</source>
        <translation>{0}, {1}: ein Punkt braucht drei endliche Zahlen, hier steht aber „{2}“.</translation>
    </message>
    <message>
        <source>{0}, {1}: a coordinate is not a finite number.</source>
        <translation>{0}, {1}: eine Koordinate ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>{0}, {1}: a face uses point {2}, which does not exist.</source>
        <translation>{0}, {1}: eine Fläche verwendet Punkt {2}, den es nicht gibt.</translation>
    </message>
    <message>
        <source>{0}, {1}: a face has {2} corners; 3 to {3} are possible.</source>
        <translation>{0}, {1}: eine Fläche hat {2} Ecken; möglich sind 3 bis {3}.</translation>
    </message>
    <message>
        <source>{0} holds no triangles.</source>
        <translation>{0} enthält keine Dreiecke.</translation>
    </message>
    <message>
        <source>{0} holds {1} points but no faces.</source>
        <translation>{0} enthält {1} Punkte, aber keine Flächen.</translation>
    </message>
    <message>
        <source>{0}, {1}: a face uses point {2}, counted from 0, but there are only {3}.</source>
        <translation>{0}, {1}: eine Fläche verwendet Punkt {2}, von 0 gezählt, es gibt aber nur {3}.</translation>
    </message>
    <message>
        <source>TetGen found no inside to fill.</source>
        <translation>TetGen fand kein Inneres zum Füllen.</translation>
    </message>
    <message>
        <source>TetGen&apos;s answer does not keep the points of the surface.</source>
        <translation>Die Antwort von TetGen behält die Punkte der Oberfläche nicht.</translation>
    </message>
    <message>
        <source>TetGen&apos;s answer holds a flat tetrahedron.</source>
        <translation>Die Antwort von TetGen enthält einen flachen Tetraeder.</translation>
    </message>
    <message>
        <source>TetGen&apos;s answer fills {0} of the surface&apos;s volume of {1}.</source>
        <translation>Die Antwort von TetGen füllt {0} vom Volumen {1} der Oberfläche.</translation>
    </message>
    <message>
        <source>TetGen split {0} of the {1} faces of the surface.</source>
        <translation>TetGen teilte {0} der {1} Flächen der Oberfläche.</translation>
    </message>
    <message>
        <source>Stopped before the end.</source>
        <translation>Vor dem Ende angehalten.</translation>
    </message>
    <message>
        <source>The worker program was stopped after {0} seconds. A smaller mesh needs less time.</source>
        <translation>Das Arbeiterprogramm wurde nach {0} Sekunden angehalten. Ein kleineres Netz braucht weniger Zeit.</translation>
    </message>
    <message>
        <source>The worker program&apos;s answer is larger than its limit of {0} MB.</source>
        <translation>Die Antwort des Arbeiterprogramms ist größer als die Grenze von {0} MB.</translation>
    </message>
    <message>
        <source>The worker program was killed. The computer may be out of memory.</source>
        <translation>Das Arbeiterprogramm wurde beendet. Vielleicht fehlt dem Rechner Speicher.</translation>
    </message>
    <message>
        <source>The worker program crashed on this mesh (signal {0}).</source>
        <translation>Das Arbeiterprogramm stürzte an diesem Netz ab (Signal {0}).</translation>
    </message>
    <message>
        <source>The worker program ended without an answer (code {0}).</source>
        <translation>Das Arbeiterprogramm endete ohne Antwort (Code {0}).</translation>
    </message>
    <message>
        <source>TetGen left out a point inside the surface.</source>
        <translation>TetGen ließ einen Punkt im Inneren der Oberfläche aus.</translation>
    </message>
    <message>
        <source>The worker program {0} could not be started: {1}.</source>
        <translation>Das Arbeiterprogramm {0} ließ sich nicht starten: {1}.</translation>
    </message>
    <message>
        <source>The worker program was asked for nothing.</source>
        <translation>Das Hilfsprogramm bekam keine Aufgabe.</translation>
    </message>
    <message>
        <source>TetGen gave up on this surface (code {0}).</source>
        <translation>TetGen gab bei dieser Oberfläche auf (Code {0}).</translation>
    </message>
    <message>
        <source>The worker program reached its memory limit on this mesh.</source>
        <translation>Das Hilfsprogramm erreichte bei diesem Netz seine Speichergrenze.</translation>
    </message>
    <message>
        <source>CGAL gave up on this surface.</source>
        <translation>CGAL gab bei dieser Oberfläche auf.</translation>
    </message>
    <message>
        <source>{0} faces were removed: repeated, without area, or loose scraps.</source>
        <translation>{0} Flächen wurden entfernt: doppelte, solche ohne Inhalt oder lose Reste.</translation>
    </message>
    <message>
        <source>{0} holes were filled with {1} faces; the largest is {2} wide.</source>
        <translation>{0} Löcher wurden mit {1} Flächen gefüllt; das größte ist {2} weit.</translation>
    </message>
    <message>
        <source>The surface was made anew about {0} places where faces crossed each other.</source>
        <translation>Die Oberfläche wurde um {0} Stellen neu gemacht, an denen Flächen einander durchdrangen.</translation>
    </message>
    <message>
        <source>{0} cannot be mended: too much of its surface would be lost.</source>
        <translation>{0} lässt sich nicht ausbessern: zu viel der Oberfläche ginge verloren.</translation>
    </message>
    <message>
        <source>{0} cannot be repaired: its surface encloses nothing.</source>
        <translation>{0} lässt sich nicht reparieren: die Oberfläche umschließt nichts.</translation>
    </message>
    <message>
        <source>The faults were too many to mend: a closed skin was made about the surface, no farther than {0} from it. Gaps narrower than {1} are bridged, sharp edges rounded.</source>
        <translation>Es waren zu viele Fehler zum Ausbessern: Um die Oberfläche wurde eine geschlossene Haut gelegt, höchstens {0} von ihr entfernt. Spalte unter {1} sind überbrückt, scharfe Kanten gerundet.</translation>
    </message>
    <message>
        <source>{0} closed surfaces inside others were removed: they are solid now.</source>
        <translation>{0} geschlossene Flächen in anderen wurden entfernt: Dort ist jetzt Vollmaterial.</translation>
    </message>
</context>
<context>
    <name>fill</name>
    <message>
        <source>Filling was cancelled.</source>
        <translation>Das Füllen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The undercuts could not be filled without the surface crossing itself. Move the parting plane a little.</source>
        <translation>Die Hinterschnitte ließen sich nicht füllen, ohne dass die Oberfläche sich selbst durchdringt. Die Trennebene ein wenig verschieben.</translation>
    </message>
    <message>
        <source>These regions cannot be filled alone: the surface would cross itself. Fill the regions beside them too.</source>
        <translation>Diese Gebiete lassen sich nicht allein füllen: die Oberfläche würde sich selbst durchdringen. Die Gebiete daneben auch füllen.</translation>
    </message>
</context>
<context>
    <name>mesh</name>
    <message>
        <source>{0} equal points were welded.</source>
        <translation>{0} gleiche Punkte wurden verschmolzen.</translation>
    </message>
    <message>
        <source>{0} faces that used a point twice were removed.</source>
        <translation>{0} Flächen, die einen Punkt zweimal verwendeten, wurden entfernt.</translation>
    </message>
    <message>
        <source>{0} repeated faces were removed.</source>
        <translation>{0} doppelte Flächen wurden entfernt.</translation>
    </message>
    <message>
        <source>{0} points within a millionth of the size of each other were welded.</source>
        <translation>{0} Punkte, die höchstens ein Millionstel der Größe auseinanderlagen, wurden verschmolzen.</translation>
    </message>
    <message>
        <source>The surface was inside out and was turned.</source>
        <translation>Die Oberfläche war nach innen gekehrt und wurde umgedreht.</translation>
    </message>
    <message>
        <source>{0} faces looked inward and were turned.</source>
        <translation>{0} Flächen sahen nach innen und wurden umgedreht.</translation>
    </message>
    <message>
        <source>{0} holds no faces.</source>
        <translation>{0} enthält keine Flächen.</translation>
    </message>
    <message>
        <source>{0} holds a coordinate that is not a finite number.</source>
        <translation>{0} enthält eine Koordinate, die keine endliche Zahl ist.</translation>
    </message>
    <message>
        <source>{0} measures {1} from corner to corner. No unit of length makes a part of that.</source>
        <translation>{0} misst {1} von Ecke zu Ecke. Keine Längeneinheit macht daraus ein Teil.</translation>
    </message>
    <message>
        <source>{0} of the {1} faces of {2} shrink to a line or a point. Its numbers have too few digits for its size or its place: write it with more digits, or nearer to the origin.</source>
        <translation>{0} der {1} Flächen von {2} schrumpfen zu einer Linie oder einem Punkt. Die Zahlen haben zu wenige Stellen für Größe oder Lage: mit mehr Stellen oder näher am Ursprung schreiben.</translation>
    </message>
    <message>
        <source>{0} consists of {1} separate solids.</source>
        <translation>{0} besteht aus {1} getrennten Körpern.</translation>
    </message>
    <message>
        <source>{0} encloses no volume, so there is nothing to cast.</source>
        <translation>{0} umschließt kein Volumen, es gibt also nichts zu gießen.</translation>
    </message>
    <message>
        <source>The surface of {0} has a hole, near {2}, so it has no inside to cast. Close it in the program that made the file.</source>
        <translation>Die Oberfläche von {0} hat ein Loch, nahe {2}, also kein Inneres zum Gießen. Es in dem Programm schließen, das die Datei gemacht hat.</translation>
    </message>
    <message>
        <source>The surface of {0} has {1} holes, one near {2}, so it has no inside to cast. Close them in the program that made the file.</source>
        <translation>Die Oberfläche von {0} hat {1} Löcher, eines nahe {2}, also kein Inneres zum Gießen. Sie in dem Programm schließen, das die Datei gemacht hat.</translation>
    </message>
    <message>
        <source>In {0} more than two faces meet at an edge: {1} faces are concerned, one near {2}. Separate the parts, or join them, in the program that made the file.</source>
        <translation>In {0} treffen sich mehr als zwei Flächen an einer Kante: {1} Flächen sind betroffen, eine nahe {2}. Die Teile in dem Programm trennen oder vereinen, das die Datei gemacht hat.</translation>
    </message>
    <message>
        <source>The surface of {0} touches itself in a single point, at {2}. Separate it there in the program that made the file.</source>
        <translation>Die Oberfläche von {0} berührt sich in einem einzelnen Punkt, bei {2}. Sie dort in dem Programm trennen, das die Datei gemacht hat.</translation>
    </message>
    <message>
        <source>The surface of {0} touches itself in {1} single points, one at {2}. Separate it there in the program that made the file.</source>
        <translation>Die Oberfläche von {0} berührt sich in {1} einzelnen Punkten, einem bei {2}. Sie dort in dem Programm trennen, das die Datei gemacht hat.</translation>
    </message>
    <message>
        <source>A face of {0} has no area, near {2}. Clean the mesh in the program that made the file.</source>
        <translation>Eine Fläche von {0} hat keinen Inhalt, nahe {2}. Das Netz in dem Programm bereinigen, das die Datei gemacht hat.</translation>
    </message>
    <message>
        <source>{1} faces of {0} have no area, one near {2}. Clean the mesh in the program that made the file.</source>
        <translation>{1} Flächen von {0} haben keinen Inhalt, eine nahe {2}. Das Netz in dem Programm bereinigen, das die Datei gemacht hat.</translation>
    </message>
    <message>
        <source>{0} crosses itself in one place, near {2}. A proof needs a surface that does not.</source>
        <translation>{0} kreuzt sich selbst an einer Stelle, nahe {2}. Ein Beweis braucht eine Oberfläche, die das nicht tut.</translation>
    </message>
    <message>
        <source>{0} crosses itself in {1} places, one near {2}. A proof needs a surface that does not.</source>
        <translation>{0} kreuzt sich selbst an {1} Stellen, eine nahe {2}. Ein Beweis braucht eine Oberfläche, die das nicht tut.</translation>
    </message>
    <message>
        <source>{0} holds a closed surface inside another, near {2}. A closed cavity cannot be cast in a two-piece mold. Remove it, or open it to the outside.</source>
        <translation>{0} enthält eine geschlossene Oberfläche in einer anderen, nahe {2}. Ein geschlossener Hohlraum lässt sich in einer zweiteiligen Form nicht gießen. Ihn entfernen oder nach außen öffnen.</translation>
    </message>
    <message>
        <source>{0} holds {1} closed surfaces inside others, one near {2}. A closed cavity cannot be cast in a two-piece mold. Remove them, or open them to the outside.</source>
        <translation>{0} enthält {1} geschlossene Oberflächen in anderen, eine nahe {2}. Ein geschlossener Hohlraum lässt sich in einer zweiteiligen Form nicht gießen. Sie entfernen oder nach außen öffnen.</translation>
    </message>
    <message>
        <source>The surface of {0} has only one side: its faces cannot all look outward, as near {1}. It has no inside to cast.</source>
        <translation>Die Oberfläche von {0} hat nur eine Seite: ihre Flächen können nicht alle nach außen sehen, so nahe {1}. Sie hat kein Inneres zum Gießen.</translation>
    </message>
</context>
<context>
    <name>moldwright::Banner</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>moldwright::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
</context>
<context>
    <name>moldwright::Dock</name>
    <message>
        <source>Float or dock %1</source>
        <translation>%1 lösen oder andocken</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>%1 schließen</translation>
    </message>
</context>
<context>
    <name>moldwright::FigureTable</name>
    <message>
        <source>%1, the current one</source>
        <translation>%1, die aktuelle</translation>
    </message>
</context>
<context>
    <name>moldwright::FrameSlider</name>
    <message>
        <source>Frames of the run</source>
        <translation>Bilder des Laufs</translation>
    </message>
    <message>
        <source>Goes back through the run; &quot;Go on from here&quot; begins another run from the frame in view.</source>
        <translation>Geht durch den Lauf zurück; „Von hier weiter“ beginnt beim gezeigten Bild einen neuen Lauf.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
</context>
<context>
    <name>moldwright::ImportDialog</name>
    <message>
        <source>Size of %1</source>
        <translation>Größe von %1</translation>
    </message>
    <message>
        <source>This part is %1 units long. What is one unit?</source>
        <translation>Dieses Teil ist %1 Einheiten lang. Was ist eine Einheit?</translation>
    </message>
    <message>
        <source>Millimetre</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetre</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Metre</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Andere Größe</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Einheit</translation>
    </message>
    <message>
        <source>&amp;Longest side</source>
        <translation>&amp;Längste Seite</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Open the part</source>
        <translation>Teil öffnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>moldwright::KeySheet</name>
    <message>
        <source>Orbit about the point under the pointer</source>
        <translation>Um den Punkt unter dem Zeiger drehen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Zoom to the pointer</source>
        <translation>Zum Zeiger zoomen</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Mouse: %1</source>
        <translation>Maus: %1</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>left button</source>
        <translation>linke Taste</translation>
    </message>
    <message>
        <source>middle button</source>
        <translation>mittlere Taste</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>rechte Taste</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
</context>
<context>
    <name>moldwright::KeyTable</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>Type other keys</source>
        <translation>Andere Tasten drücken</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>%1 belongs to %2. Give that command other keys first.</source>
        <translation>%1 gehört zu %2. Geben Sie zuerst jenem Befehl andere Tasten.</translation>
    </message>
</context>
<context>
    <name>moldwright::MainWindow</name>
    <message>
        <source>%1 to plane normal</source>
        <translation>%1 zur Ebenennormalen</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
    <message>
        <source>Moldwright</source>
        <translation>Moldwright</translation>
    </message>
    <message>
        <source>%1 (changed) · Moldwright</source>
        <translation>%1 (geändert) · Moldwright</translation>
    </message>
    <message>
        <source>%1 · Moldwright</source>
        <translation>%1 · Moldwright</translation>
    </message>
    <message>
        <source>&lt;b&gt;?&lt;/b&gt; shows all keys.</source>
        <translation>&lt;b&gt;?&lt;/b&gt; zeigt alle Tasten.</translation>
    </message>
    <message>
        <source>Open a part, drop one here, or choose a sample. %1</source>
        <translation>Ein Teil öffnen, hier ablegen oder ein Beispiel wählen. %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; the face that shall lie on the ground. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>Die Fläche &lt;b&gt;anklicken&lt;/b&gt;, die auf dem Boden liegen soll. &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>&lt;b&gt;X&lt;/b&gt; opens and closes the mold. %1</source>
        <translation>&lt;b&gt;X&lt;/b&gt; öffnet und schließt die Form. %1</translation>
    </message>
    <message>
        <source>Directions along the normal</source>
        <translation>Richtungen entlang der Normalen</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Gespeichert %1</translation>
    </message>
    <message>
        <source>Move the plane</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Moldwright projects (*.moldwright)</source>
        <translation>Moldwright-Projekte (*.moldwright)</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Close without saving</source>
        <translation>Schließen ohne Speichern</translation>
    </message>
    <message>
        <source>Keep it open</source>
        <translation>Offen lassen</translation>
    </message>
    <message>
        <source>Open a part</source>
        <translation>Teil öffnen</translation>
    </message>
    <message>
        <source>Parts and projects (*.stl *.obj *.ply *.off *.moldwright);;All files (*)</source>
        <translation>Teile und Projekte (*.stl *.obj *.ply *.off *.moldwright);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export the shape</source>
        <translation>Form exportieren</translation>
    </message>
    <message>
        <source>STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;OFF (*.off)</source>
        <translation>STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;OFF (*.off)</translation>
    </message>
    <message>
        <source>Folder for the halves</source>
        <translation>Ordner für die Hälften</translation>
    </message>
    <message>
        <source>Print the report</source>
        <translation>Bericht drucken</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be written to %1.</source>
        <translation>Das Bild konnte nicht nach %1 geschrieben werden.</translation>
    </message>
    <message>
        <source>About Moldwright</source>
        <translation>Über Moldwright</translation>
    </message>
    <message>
        <source>Takes any closed mesh to a castable shape and a proved two-piece mold, after Stein et al. 2019. Free software under the GNU AGPL 3 or later. Built on Qt, VTK, CGAL, OpenMesh, Eigen, TetGen and oneTBB.</source>
        <translation>Bringt jedes geschlossene Netz zu einer gießbaren Form und einer bewiesenen zweiteiligen Gussform, nach Stein u. a. 2019. Freie Software unter der GNU AGPL 3 oder neuer. Gebaut mit Qt, VTK, CGAL, OpenMesh, Eigen, TetGen und oneTBB.</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Felder</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>Mouse &amp;navigation</source>
        <translation>Maus&amp;steuerung</translation>
    </message>
    <message>
        <source>Like the desktop</source>
        <translation>Wie der Schreibtisch</translation>
    </message>
    <message>
        <source>Navigation: %1</source>
        <translation>Steuerung: %1</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Verformen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Mold</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Every edit appears here. Click one to go back to it.</source>
        <translation>Jede Änderung erscheint hier. Ein Klick führt zu ihr zurück.</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>The shape rests. &lt;b&gt;Space&lt;/b&gt; bends it further, &lt;b&gt;Ctrl+Shift+Return&lt;/b&gt; finishes it.</source>
        <translation>Die Form ruht. &lt;b&gt;Leertaste&lt;/b&gt; biegt weiter, &lt;b&gt;Strg+Umschalt+Eingabe&lt;/b&gt; stellt fertig.</translation>
    </message>
    <message>
        <source>Turn direction 1</source>
        <translation>Richtung 1 drehen</translation>
    </message>
    <message>
        <source>Turn direction 2</source>
        <translation>Richtung 2 drehen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag&lt;/b&gt; a grip of the plane or the tip of an arrow, with &lt;b&gt;Ctrl&lt;/b&gt; in whole steps. %1</source>
        <translation>Einen Griff der Ebene oder eine Pfeilspitze &lt;b&gt;ziehen&lt;/b&gt;, mit &lt;b&gt;Strg&lt;/b&gt; in ganzen Schritten. %1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; a place, a second for the distance, a third for the angle. &lt;b&gt;Ctrl+C&lt;/b&gt; copies, &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>Eine Stelle &lt;b&gt;anklicken&lt;/b&gt;, eine zweite für den Abstand, eine dritte für den Winkel. &lt;b&gt;Strg+C&lt;/b&gt; kopiert, &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>Rundumansicht speichern</translation>
    </message>
    <message>
        <source>Animated PNG (*.png)</source>
        <translation>Animiertes PNG (*.png)</translation>
    </message>
    <message>
        <source>Picture %1 of %2 around the part. &lt;b&gt;Esc&lt;/b&gt; stops.</source>
        <translation>Bild %1 von %2 rund um das Teil. &lt;b&gt;Esc&lt;/b&gt; hält an.</translation>
    </message>
    <message>
        <source>Turntable written to %1.</source>
        <translation>Rundumansicht nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Pins from a file</source>
        <translation>Heftpunkte aus einer Datei</translation>
    </message>
    <message>
        <source>Pins (*.json);;All files (*)</source>
        <translation>Heftpunkte (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Pins into a file</source>
        <translation>Heftpunkte in eine Datei</translation>
    </message>
    <message>
        <source>Pins (*.json)</source>
        <translation>Heftpunkte (*.json)</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; a point of the surface to pin it, with &lt;b&gt;Shift&lt;/b&gt; the point inside below it. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;Klicken&lt;/b&gt; heftet einen Punkt der Oberfläche an, mit &lt;b&gt;Umschalt&lt;/b&gt; den Punkt innen darunter. &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; to pin the point inside below the pointer, with &lt;b&gt;Shift&lt;/b&gt; the one on the surface. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;Klicken&lt;/b&gt; heftet den Punkt innen unter dem Zeiger an, mit &lt;b&gt;Umschalt&lt;/b&gt; den auf der Oberfläche. &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; the face that the parting plane shall lie in. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;Klicken&lt;/b&gt; Sie die Fläche an, in der die Trennebene liegen soll. &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; point %1 of 3 that the parting plane shall run through. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;Klicken&lt;/b&gt; Sie Punkt %1 von 3 an, durch den die Trennebene gehen soll. &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>These points lie on a line, so they give no plane. Click three others.</source>
        <translation>Diese Punkte liegen auf einer Geraden und ergeben keine Ebene. Klicken Sie drei andere an.</translation>
    </message>
    <message>
        <source>Snap the plane</source>
        <translation>Ebene einrasten</translation>
    </message>
    <message>
        <source>Click the sitting rabbit. A part of your own opens with %1.</source>
        <translation>Klicken Sie auf den sitzenden Hasen. Ein eigenes Teil öffnet %1.</translation>
    </message>
    <message>
        <source>Choose where the mold parts</source>
        <translation>Wählen, wo die Form sich teilt</translation>
    </message>
    <message>
        <source>%1 searches the best planes. Try the pictures at the right: red is what would lock in the mold, and less of it is to be bent.</source>
        <translation>%1 sucht die besten Ebenen. Probieren Sie die Bilder rechts: Rot ist, was in der Form hängen bliebe; je weniger, desto weniger ist zu biegen.</translation>
    </message>
    <message>
        <source>Bend it until it comes out</source>
        <translation>Biegen, bis es herauskommt</translation>
    </message>
    <message>
        <source>%1 runs. The part bends before your eyes until nothing is red, and the result is proved. What you want to hold on the plane, pin it first, under Guides.</source>
        <translation>%1 startet. Das Teil biegt sich vor Ihren Augen, bis nichts mehr rot ist, und das Ergebnis wird bewiesen. Was auf der Ebene bleiben soll, heften Sie vorher an, unter Führung.</translation>
    </message>
    <message>
        <source>Look at it</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>Turn it with %1 held. %2 paints how far cast and part are apart, %3 how steep each face is. If an ear went wrong, take another plane and run again.</source>
        <translation>Drehen Sie es mit %1. %2 malt, wie weit Guss und Teil auseinander sind, %3, wie steil jede Fläche ist. Ging ein Ohr daneben, nehmen Sie eine andere Ebene und starten neu.</translation>
    </message>
    <message>
        <source>Shift and the middle button</source>
        <translation>Umschalt und mittlerer Taste</translation>
    </message>
    <message>
        <source>Make the mold</source>
        <translation>Die Form bauen</translation>
    </message>
    <message>
        <source>%1 builds both halves and proves that they open. %2 moves them apart; %3 writes them to files.</source>
        <translation>%1 baut beide Hälften und beweist, dass sie sich öffnen. %2 bewegt sie auseinander; %3 schreibt sie in Dateien.</translation>
    </message>
    <message>
        <source>Crease up to %1</source>
        <translation>Knick bis %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;B&lt;/b&gt; takes the brush; &lt;b&gt;F2&lt;/b&gt; renames the region, &lt;b&gt;Del&lt;/b&gt; removes it. %1</source>
        <translation>&lt;b&gt;B&lt;/b&gt; nimmt den Pinsel; &lt;b&gt;F2&lt;/b&gt; benennt die Region um, &lt;b&gt;Entf&lt;/b&gt; entfernt sie. %1</translation>
    </message>
    <message>
        <source>Regions from a file</source>
        <translation>Regionen aus einer Datei</translation>
    </message>
    <message>
        <source>Regions (*.json);;All files (*)</source>
        <translation>Regionen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Regions into a file</source>
        <translation>Regionen in eine Datei</translation>
    </message>
    <message>
        <source>Regions (*.json)</source>
        <translation>Regionen (*.json)</translation>
    </message>
    <message>
        <source>a new region</source>
        <translation>einer neuen Region</translation>
    </message>
    <message>
        <source>Strokes halve the weight.</source>
        <translation>Striche halbieren das Gewicht.</translation>
    </message>
    <message>
        <source>Strokes double the weight in %1.</source>
        <translation>Striche verdoppeln das Gewicht in %1.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw&lt;/b&gt; around the faces. %1 With &lt;b&gt;Ctrl&lt;/b&gt; the opposite, &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>Um die Flächen &lt;b&gt;herumfahren&lt;/b&gt;. %1 Mit &lt;b&gt;Strg&lt;/b&gt; umgekehrt, &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; a face. %1 With &lt;b&gt;Ctrl&lt;/b&gt; the opposite, &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>Eine Fläche &lt;b&gt;anklicken&lt;/b&gt;. %1 Mit &lt;b&gt;Strg&lt;/b&gt; umgekehrt, &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw&lt;/b&gt; over the part. %1 With &lt;b&gt;Ctrl&lt;/b&gt; the opposite, &lt;b&gt;F&lt;/b&gt; or &lt;b&gt;Alt+wheel&lt;/b&gt; resizes, &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>Über das Teil &lt;b&gt;malen&lt;/b&gt;. %1 Mit &lt;b&gt;Strg&lt;/b&gt; umgekehrt, &lt;b&gt;F&lt;/b&gt; oder &lt;b&gt;Alt+Mausrad&lt;/b&gt; ändert die Größe, &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>The part bends; plane, pins and draft may change meanwhile. &lt;b&gt;Space&lt;/b&gt; holds it, &lt;b&gt;Ctrl+.&lt;/b&gt; stops it.</source>
        <translation>Das Teil verformt sich; Ebene, Heftpunkte und Schräge dürfen sich dabei ändern. &lt;b&gt;Leertaste&lt;/b&gt; hält es an, &lt;b&gt;Strg+.&lt;/b&gt; bricht ab.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Return&lt;/b&gt; makes the chosen variant the current one, &lt;b&gt;Ctrl+D&lt;/b&gt; duplicates it, &lt;b&gt;F2&lt;/b&gt; renames it, &lt;b&gt;Del&lt;/b&gt; removes it. %1</source>
        <translation>&lt;b&gt;Eingabe&lt;/b&gt; macht die gewählte Variante zur aktuellen, &lt;b&gt;Strg+D&lt;/b&gt; dupliziert sie, &lt;b&gt;F2&lt;/b&gt; benennt sie um, &lt;b&gt;Entf&lt;/b&gt; entfernt sie. %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag&lt;/b&gt; a disc to place a feature of the mold, with &lt;b&gt;Shift&lt;/b&gt; without steps. %1</source>
        <translation>Eine Scheibe &lt;b&gt;ziehen&lt;/b&gt;, um ein Element der Form zu setzen, mit &lt;b&gt;Umschalt&lt;/b&gt; ohne Schritte. %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw&lt;/b&gt; around the suggested points that shall be pinned. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;Zeichnen&lt;/b&gt; Sie um die vorgeschlagenen Punkte herum, die angeheftet werden sollen. &lt;b&gt;Esc&lt;/b&gt; beendet.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Not saved when Moldwright ended. Kept as it was at %1.</source>
        <translation>Nicht gespeichert, als Moldwright endete. Aufbewahrt, wie es um %1 war.</translation>
    </message>
    <message>
        <source>Work of %1</source>
        <translation>Arbeit von %1</translation>
    </message>
    <message>
        <source>Not saved when Moldwright ended, and what was kept cannot be read.</source>
        <translation>Nicht gespeichert, als Moldwright endete, und was aufbewahrt wurde, lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>Another part was not saved when Moldwright ended.</source>
        <translation>Ein anderes Teil war nicht gespeichert, als Moldwright endete.</translation>
    </message>
    <message>
        <source>%1 was kept as it was at %2.</source>
        <translation>%1 ist aufbewahrt, wie es um %2 war.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; a pin to choose it, with &lt;b&gt;Ctrl&lt;/b&gt; several, or draw a box; &lt;b&gt;Del&lt;/b&gt; removes them; &lt;b&gt;P&lt;/b&gt; pins another point. %1</source>
        <translation>&lt;b&gt;Klick&lt;/b&gt; wählt einen Heftpunkt, mit &lt;b&gt;Strg&lt;/b&gt; mehrere, auch mit einem Rahmen; &lt;b&gt;Entf&lt;/b&gt; entfernt sie; &lt;b&gt;P&lt;/b&gt; setzt einen weiteren. %1</translation>
    </message>
    <message>
        <source>No suggested point is seen inside the lasso.</source>
        <translation>Im Lasso ist kein vorgeschlagener Punkt zu sehen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;F3&lt;/b&gt; goes from place to place, &lt;b&gt;Ctrl+R&lt;/b&gt; repairs the mesh, &lt;b&gt;F5&lt;/b&gt; reads the file again, &lt;b&gt;Esc&lt;/b&gt; goes back to what was open. %1</source>
        <translation>&lt;b&gt;F3&lt;/b&gt; geht von Stelle zu Stelle, &lt;b&gt;Strg+R&lt;/b&gt; repariert das Netz, &lt;b&gt;F5&lt;/b&gt; liest die Datei erneut, &lt;b&gt;Esc&lt;/b&gt; geht zurück zu dem, was offen war. %1</translation>
    </message>
    <message>
        <source>Half %1</source>
        <translation>Hälfte %1</translation>
    </message>
    <message>
        <source>opens along direction %1</source>
        <translation>öffnet sich entlang Richtung %1</translation>
    </message>
    <message>
        <source>Smallest steel</source>
        <translation>Kleinster Stahl</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Steel between features</source>
        <translation>Stahl zwischen Merkmalen</translation>
    </message>
    <message>
        <source>Add parts to the mold</source>
        <translation>Teile in die Form aufnehmen</translation>
    </message>
    <message>
        <source>Moldwright projects (*.moldwright);;All files (*)</source>
        <translation>Moldwright-Projekte (*.moldwright);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>moldwright::MessageList</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Nothing to report.</source>
        <translation>Nichts zu melden.</translation>
    </message>
</context>
<context>
    <name>moldwright::PartView</name>
    <message>
        <source>View of the part</source>
        <translation>Ansicht des Teils</translation>
    </message>
</context>
<context>
    <name>moldwright::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Find a preference or a key</source>
        <translation>Eine Einstellung oder Taste finden</translation>
    </message>
    <message>
        <source>No preference has these words.</source>
        <translation>Keine Einstellung hat diese Wörter.</translation>
    </message>
    <message>
        <source>Appearance and mouse</source>
        <translation>Aussehen und Maus</translation>
    </message>
    <message>
        <source>Like the desktop</source>
        <translation>Wie der Schreibtisch</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Mouse navigation</source>
        <translation>Navigation mit der Maus</translation>
    </message>
    <message>
        <source>New parts begin with</source>
        <translation>Neue Teile beginnen mit</translation>
    </message>
    <message>
        <source>Draft required</source>
        <translation>Verlangte Schräge</translation>
    </message>
    <message>
        <source>Tilt limit</source>
        <translation>Größte Neigung</translation>
    </message>
    <message>
        <source>Wall of the mold</source>
        <translation>Wand der Form</translation>
    </message>
</context>
<context>
    <name>moldwright::ProgressPlots</name>
    <message>
        <source>Energy, worst draft and violating area over the steps</source>
        <translation>Energie, kleinste Schräge und verletzende Fläche über den Schritten</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>Kleinste Schräge</translation>
    </message>
    <message>
        <source>Area below %1°</source>
        <translation>Fläche unter %1°</translation>
    </message>
    <message>
        <source>A run draws energy, worst draft and area here, step by step.</source>
        <translation>Ein Lauf zeichnet hier Schritt für Schritt Energie, Schräge und Fläche.</translation>
    </message>
</context>
<context>
    <name>moldwright::ProjectModel</name>
    <message>
        <source>shown</source>
        <translation>sichtbar</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
</context>
<context>
    <name>moldwright::ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
</context>
<context>
    <name>moldwright::PropertyPanel</name>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
</context>
<context>
    <name>moldwright::SectionBar</name>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>At the parting plane</source>
        <translation>An der Trennebene</translation>
    </message>
    <message>
        <source>Across X</source>
        <translation>Quer zu X</translation>
    </message>
    <message>
        <source>Across Y</source>
        <translation>Quer zu Y</translation>
    </message>
    <message>
        <source>Across Z</source>
        <translation>Quer zu Z</translation>
    </message>
    <message>
        <source>Which way the section lies</source>
        <translation>Wie der Schnitt liegt</translation>
    </message>
    <message>
        <source>How far along the section lies</source>
        <translation>Wo der Schnitt liegt</translation>
    </message>
    <message>
        <source>Keep the other side</source>
        <translation>Die andere Seite behalten</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>Schnitt schließen</translation>
    </message>
    <message>
        <source>Facing the view</source>
        <translation>Zur Ansicht gewandt</translation>
    </message>
</context>
<context>
    <name>moldwright::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Or drop a file anywhere: STL, OBJ, PLY, OFF, Moldwright projects.</source>
        <translation>Oder eine Datei irgendwo ablegen: STL, OBJ, PLY, OFF, Moldwright-Projekte.</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Closed parts that you would really cast. Each opens as a copy.</source>
        <translation>Geschlossene Teile, die man wirklich gießen würde. Jedes öffnet sich als Kopie.</translation>
    </message>
</context>
<context>
    <name>moldwright::StatusProgress</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>moldwright::Tour</name>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>moldwright::TurnDialog</name>
    <message>
        <source>Turn the part</source>
        <translation>Das Teil drehen</translation>
    </message>
    <message>
        <source>X axis</source>
        <translation>x-Achse</translation>
    </message>
    <message>
        <source>Y axis</source>
        <translation>y-Achse</translation>
    </message>
    <message>
        <source>Z axis</source>
        <translation>z-Achse</translation>
    </message>
    <message>
        <source>Normal of the parting plane</source>
        <translation>Normale der Trennebene</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>&amp;Um</translation>
    </message>
    <message>
        <source>A&amp;ngle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>moldwright::ViewBar</name>
    <message>
        <source>Tools of the view</source>
        <translation>Werkzeuge der Ansicht</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeige</translation>
    </message>
    <message>
        <source>What the faces show</source>
        <translation>Was die Flächen zeigen</translation>
    </message>
</context>
<context>
    <name>moldwright::ViewPane</name>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Free view</source>
        <translation>Freie Ansicht</translation>
    </message>
    <message>
        <source>What this view shows</source>
        <translation>Was diese Ansicht zeigt</translation>
    </message>
    <message>
        <source>Newest shape</source>
        <translation>Neueste Form</translation>
    </message>
    <message>
        <source>Part as opened</source>
        <translation>Teil wie geöffnet</translation>
    </message>
    <message>
        <source>What the faces of this view show</source>
        <translation>Was die Flächen dieser Ansicht zeigen</translation>
    </message>
    <message>
        <source>Compared variant</source>
        <translation>Verglichene Variante</translation>
    </message>
</context>
<context>
    <name>moldwright::Workbench</name>
    <message>
        <source>Suggested plane</source>
        <translation>Vorgeschlagene Ebene</translation>
    </message>
    <message>
        <source>Suggested plane taken: nothing is in the way of the mold there. Run bends the part.</source>
        <translation>Vorgeschlagene Ebene genommen: dort steht der Form nichts im Weg. Starten biegt das Teil.</translation>
    </message>
    <message>
        <source>Something inside Moldwright broke; your work is as it was.</source>
        <translation>In Moldwright ist etwas kaputtgegangen; die Arbeit ist, wie sie war.</translation>
    </message>
    <message>
        <source>%1 was stopped.</source>
        <translation>%1 wurde angehalten.</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>Teil drehen</translation>
    </message>
    <message>
        <source>Lay the part flat</source>
        <translation>Teil hinlegen</translation>
    </message>
    <message>
        <source>Move the part to the middle</source>
        <translation>Teil in die Mitte rücken</translation>
    </message>
    <message>
        <source>Restore the original shape</source>
        <translation>Ursprüngliche Form</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Searching planes</source>
        <translation>Ebenensuche</translation>
    </message>
    <message>
        <source>The search for planes was stopped.</source>
        <translation>Die Ebenensuche wurde angehalten.</translation>
    </message>
    <message>
        <source>Best plane</source>
        <translation>Beste Ebene</translation>
    </message>
    <message>
        <source>Plane %1 of the search</source>
        <translation>Ebene %1 der Suche</translation>
    </message>
    <message>
        <source>Plane %1 of %2 taken: %3 % of the surface below %4°.</source>
        <translation>Ebene %1 von %2 genommen: %3 % der Oberfläche unter %4°.</translation>
    </message>
    <message>
        <source>Searching directions</source>
        <translation>Richtungssuche</translation>
    </message>
    <message>
        <source>Best directions</source>
        <translation>Beste Richtungen</translation>
    </message>
    <message>
        <source>Deforming</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Verformen</translation>
    </message>
    <message>
        <source>Castable: proved at %1°, mean distance to the part %2 % of its diagonal.</source>
        <translation>Gießbar: bewiesen bei %1°, mittlerer Abstand zum Teil %2 % seiner Diagonale.</translation>
    </message>
    <message>
        <source>Not castable yet: %1</source>
        <translation>Noch nicht gießbar: %1</translation>
    </message>
    <message>
        <source>Building the mold</source>
        <translation>Formenbau</translation>
    </message>
    <message>
        <source>Mold built: both halves are proved to come off.</source>
        <translation>Form gebaut: beide Hälften lassen sich bewiesen abziehen.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>%1 opened.</source>
        <translation>%1 geöffnet.</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>%1 opened: %2 × %3 × %4 mm, closed.</source>
        <translation>%1 geöffnet: %2 × %3 × %4 mm, geschlossen.</translation>
    </message>
    <message>
        <source>The shape was not written: the file&apos;s name must end in stl, ply, obj or off.</source>
        <translation>Die Form wurde nicht geschrieben: der Dateiname muss auf stl, ply, obj oder off enden.</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Shape written to %1.</source>
        <translation>Form nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Writing the halves</source>
        <translation>Hälften werden geschrieben</translation>
    </message>
    <message>
        <source>Mold halves written to %1.</source>
        <translation>Formhälften nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>moldwright-render could not be started.</source>
        <translation>moldwright-render ließ sich nicht starten.</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Er wurde angehalten.</translation>
    </message>
    <message>
        <source>Drawing the report</source>
        <translation>Bericht wird gezeichnet</translation>
    </message>
    <message>
        <source>The report was not written. %1</source>
        <translation>Der Bericht wurde nicht geschrieben. %1</translation>
    </message>
    <message>
        <source>The report was not written.</source>
        <translation>Der Bericht wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>Report written to %1.</source>
        <translation>Bericht nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Turn the part by %1°</source>
        <translation>Das Teil um %1° drehen</translation>
    </message>
    <message>
        <source>Fill where bending fails</source>
        <translation>Füllen, wo Biegen nicht hilft</translation>
    </message>
    <message>
        <source>The run was stopped before it had a shape. The part is as it was.</source>
        <translation>Der Lauf wurde angehalten, bevor er eine Gestalt hatte. Das Teil ist, wie es war.</translation>
    </message>
    <message>
        <source>Deform, stopped</source>
        <translation>Verformen, angehalten</translation>
    </message>
    <message>
        <source>Filled: %1 % of the part&apos;s volume, at places that no bending frees.</source>
        <translation>Gefüllt: %1 % des Volumens des Teils, wo kein Biegen hilft.</translation>
    </message>
    <message>
        <source>%1 of %2 on side %3: filled.</source>
        <translation>%1, %2, auf Seite %3: gefüllt.</translation>
    </message>
    <message>
        <source>The run was stopped. What it reached is kept, and not castable yet.</source>
        <translation>Der Lauf wurde angehalten. Was er erreicht hat, bleibt; es ist noch nicht gießbar.</translation>
    </message>
    <message>
        <source>%1 % of the surface is below %2°. Run bends the part again, at the plane it had; Undo brings back what was before.</source>
        <translation>%1 % der Oberfläche liegen unter %2°. Start biegt das Teil neu, an derselben Ebene; Rückgängig holt zurück, was vorher war.</translation>
    </message>
    <message>
        <source>Plane of the run</source>
        <translation>Ebene des Laufs</translation>
    </message>
    <message>
        <source>At this plane one place stands in the way, however the part is bent.</source>
        <translation>An dieser Ebene ist eine Stelle im Weg, wie man das Teil auch biegt.</translation>
    </message>
    <message>
        <source>At this plane %1 places stand in the way, however the part is bent.</source>
        <translation>An dieser Ebene sind %1 Stellen im Weg, wie man das Teil auch biegt.</translation>
    </message>
    <message>
        <source>Looking for undercuts</source>
        <translation>Suche nach Hinterschnitten</translation>
    </message>
    <message>
        <source>%1 undercuts at this plane; %2 that no bending frees.</source>
        <translation>%1 Hinterschnitte an dieser Ebene; %2 befreit kein Biegen.</translation>
    </message>
    <message>
        <source>Undercut by the rule</source>
        <translation>Hinterschnitt nach der Regel</translation>
    </message>
    <message>
        <source>Fill an undercut</source>
        <translation>Einen Hinterschnitt füllen</translation>
    </message>
    <message>
        <source>Bend an undercut</source>
        <translation>Einen Hinterschnitt biegen</translation>
    </message>
    <message>
        <source>Fill an obstruction</source>
        <translation>Ein Hindernis füllen</translation>
    </message>
    <message>
        <source>It will be filled. Nothing else stands in the way: Run bends the rest.</source>
        <translation>Es wird gefüllt. Sonst steht nichts im Weg: Start biegt den Rest.</translation>
    </message>
    <message>
        <source>No direction keeps to the axis and to the tilt limit at this plane. Turn the plane, or allow more.</source>
        <translation>Keine Richtung hält sich an dieser Ebene an Achse und Neigungsgrenze. Die Ebene drehen oder mehr zulassen.</translation>
    </message>
    <message>
        <source>Pin a point</source>
        <translation>Punkt anheften</translation>
    </message>
    <message>
        <source>Remove all pins</source>
        <translation>Alle Heftpunkte entfernen</translation>
    </message>
    <message>
        <source>Reading pins</source>
        <translation>Heftpunkte lesen</translation>
    </message>
    <message>
        <source>Pins from a file</source>
        <translation>Heftpunkte aus einer Datei</translation>
    </message>
    <message>
        <source>%1 pins read from %2.</source>
        <translation>%1 Heftpunkte aus %2 gelesen.</translation>
    </message>
    <message>
        <source>Pins written to %1.</source>
        <translation>Heftpunkte in %1 geschrieben.</translation>
    </message>
    <message>
        <source>Looking for pins</source>
        <translation>Heftpunkte suchen</translation>
    </message>
    <message>
        <source>%1 pins are suggested. Click a faint ring to take one.</source>
        <translation>%1 Heftpunkte sind vorgeschlagen. Ein Klick auf einen blassen Ring nimmt ihn an.</translation>
    </message>
    <message>
        <source>Pins: %1, at most %2 mm from the plane.</source>
        <translation>Heftpunkte: %1, höchstens %2 mm von der Ebene.</translation>
    </message>
    <message>
        <source>It will be filled. One more place to decide on.</source>
        <translation>Es wird gefüllt. Über eine weitere Stelle ist zu entscheiden.</translation>
    </message>
    <message>
        <source>It will be filled. %1 more places to decide on.</source>
        <translation>Es wird gefüllt. Über %1 weitere Stellen ist zu entscheiden.</translation>
    </message>
    <message>
        <source>Region %1</source>
        <translation>Region %1</translation>
    </message>
    <message>
        <source>Erase importance</source>
        <translation>Wichtigkeit radieren</translation>
    </message>
    <message>
        <source>Paint importance</source>
        <translation>Wichtigkeit malen</translation>
    </message>
    <message>
        <source>Looking which faces are seen</source>
        <translation>Sichtbare Flächen suchen</translation>
    </message>
    <message>
        <source>No face&apos;s middle is seen inside the lasso.</source>
        <translation>Im Lasso ist keine Fläche mit ihrer Mitte zu sehen.</translation>
    </message>
    <message>
        <source>Change a region&apos;s weight</source>
        <translation>Gewicht einer Region ändern</translation>
    </message>
    <message>
        <source>Change a region&apos;s limit</source>
        <translation>Grenze einer Region ändern</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Remove all regions</source>
        <translation>Alle Regionen entfernen</translation>
    </message>
    <message>
        <source>Reading regions</source>
        <translation>Regionen lesen</translation>
    </message>
    <message>
        <source>Regions from a file</source>
        <translation>Regionen aus einer Datei</translation>
    </message>
    <message>
        <source>%1 regions read from %2.</source>
        <translation>%1 Regionen aus %2 gelesen.</translation>
    </message>
    <message>
        <source>Regions written to %1.</source>
        <translation>Regionen in %1 geschrieben.</translation>
    </message>
    <message>
        <source>%1 kept its shape within %2 mm: it changed by %3 mm.</source>
        <translation>%1 hat die Form auf %2 mm gehalten: Sie änderte sich um %3 mm.</translation>
    </message>
    <message>
        <source>%1 changed its shape by %2 mm, more than the %3 mm allowed. Give it more weight, or take another plane.</source>
        <translation>%1 hat die Form um %2 mm geändert, mehr als die erlaubten %3 mm. Geben Sie mehr Gewicht oder nehmen Sie eine andere Ebene.</translation>
    </message>
    <message>
        <source>Changed during the run</source>
        <translation>Während des Laufs geändert</translation>
    </message>
    <message>
        <source>The run has ended without the last changes.</source>
        <translation>Der Lauf endete ohne die letzten Änderungen.</translation>
    </message>
    <message>
        <source>Run bends the part with them; Undo brings back the cast without them.</source>
        <translation>Start verformt das Teil mit ihnen; Rückgängig holt den Guss ohne sie zurück.</translation>
    </message>
    <message>
        <source>A run cannot take this up while it goes on. The next run does.</source>
        <translation>Ein Lauf kann dies nicht übernehmen, während er läuft. Der nächste tut es.</translation>
    </message>
    <message>
        <source>Go on from step %1</source>
        <translation>Von Schritt %1 weiter</translation>
    </message>
    <message>
        <source>Variant %1</source>
        <translation>Variante %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>%1 is a copy of %2, and the current variant now.</source>
        <translation>%1 ist eine Kopie von %2 und jetzt die aktuelle Variante.</translation>
    </message>
    <message>
        <source>New variant</source>
        <translation>Neue Variante</translation>
    </message>
    <message>
        <source>%1 is a new variant, without pins and regions, and the current one now.</source>
        <translation>%1 ist eine neue Variante ohne Heftpunkte und Regionen und jetzt die aktuelle.</translation>
    </message>
    <message>
        <source>There is a variant %1 already. Take another name.</source>
        <translation>Es gibt schon eine Variante %1. Nehmen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <translation>Heftpunkt %1</translation>
    </message>
    <message>
        <source>Change regions' weights</source>
        <translation>Gewichte von Regionenn ändern</translation>
    </message>
    <message>
        <source>Change regions' limits</source>
        <translation>Grenzen von Regionenn ändern</translation>
    </message>
    <message>
        <source>Remove %1 regions</source>
        <translation>%1 Regionen entfernen</translation>
    </message>
    <message>
        <source>Remove %1 pins</source>
        <translation>%1 Heftpunkte entfernen</translation>
    </message>
    <message>
        <source>Repairing %1</source>
        <translation>%1 reparieren</translation>
    </message>
    <message>
        <source>Repairing</source>
        <translation>Reparieren</translation>
    </message>
    <message>
        <source>No undercut at this plane.</source>
        <translation>Kein Hinterschnitt an dieser Ebene.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 lesen</translation>
    </message>
    <message>
        <source>Reading %1 parts</source>
        <translation>%1 Teile lesen</translation>
    </message>
    <message>
        <source>Add %1 to the mold</source>
        <translation>%1 in die Form aufnehmen</translation>
    </message>
    <message>
        <source>Add %1 parts to the mold</source>
        <translation>%1 Teile in die Form aufnehmen</translation>
    </message>
    <message>
        <source>%1 has a cavity in the mold now.</source>
        <translation>%1 hat jetzt eine Kavität in der Form.</translation>
    </message>
    <message>
        <source>Read %1 again</source>
        <translation>%1 erneut lesen</translation>
    </message>
    <message>
        <source>%1 is in its file as it is in the mold.</source>
        <translation>%1 ist in seiner Datei so wie in der Form.</translation>
    </message>
    <message>
        <source>%1 was read again.</source>
        <translation>%1 wurde erneut gelesen.</translation>
    </message>
    <message>
        <source>Cavities of %1</source>
        <translation>Kavitäten von %1</translation>
    </message>
</context>
<context>
    <name>moldwright::WorkflowBar</name>
    <message>
        <source>Workflow</source>
        <translation>Arbeitsablauf</translation>
    </message>
</context>
<context>
    <name>pins</name>
    <message>
        <source>The search for pins was cancelled.</source>
        <translation>Die Suche nach Stiften wurde abgebrochen.</translation>
    </message>
</context>
<context>
    <name>moldwright::PaintTool</name>
    <message>
        <source>A lasso looks for its faces once the run has ended. The other brushes paint while it goes on.</source>
        <translation>Ein Lasso sucht seine Flächen erst, wenn der Lauf zu Ende ist. Die anderen Pinsel malen währenddessen.</translation>
    </message>
</context>
<context>
    <name>Presets</name>
    <message>
        <source>Save as a preset</source>
        <translation>Als Vorgabe speichern</translation>
    </message>
    <message>
        <source>Name; one that is there already is replaced:</source>
        <translation>Name; eine vorhandene wird ersetzt:</translation>
    </message>
    <message>
        <source>The settings are none of the presets. Take one over to remove it.</source>
        <translation>Die Einstellungen sind keine der Vorgaben. Zum Entfernen zuerst eine übernehmen.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Block, layout, features and machines as they were saved under a name. Shrink and density stay as they are.</source>
        <translation>Block, Anordnung, Merkmale und Maschinen, wie sie unter einem Namen gespeichert wurden. Schwindung und Dichte bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>As set here</source>
        <translation>Wie hier eingestellt</translation>
    </message>
    <message>
        <source>There is no preset {0}: none has been saved yet in {1}.</source>
        <translation>Es gibt keine Vorgabe {0}: In {1} ist noch keine gespeichert.</translation>
    </message>
    <message>
        <source>There is no preset {0}. There are: {1}.</source>
        <translation>Es gibt keine Vorgabe {0}. Es gibt: {1}.</translation>
    </message>
    <message>
        <source>The preset {0} cannot be understood. Save it anew, or remove it.</source>
        <translation>Die Vorgabe {0} ist nicht zu verstehen. Neu speichern oder entfernen.</translation>
    </message>
    <message>
        <source>A preset cannot be called “{0}”. Take up to 60 letters, digits, spaces, hyphens or dots between.</source>
        <translation>Eine Vorgabe kann nicht „{0}“ heißen. Erlaubt sind bis zu 60 Buchstaben, Ziffern, und dazwischen Leerzeichen, Bindestriche oder Punkte.</translation>
    </message>
    <message>
        <source>{0} could not be removed: {1}.</source>
        <translation>{0} ließ sich nicht entfernen: {1}.</translation>
    </message>
</context>
<context>
    <name>moldwright::LostCardFrame</name>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Ordner zeigen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Puts it into the trash.</source>
        <translation>Legt es in den Papierkorb.</translation>
    </message>
</context>
<context>
    <name>moldwright::Program</name>
    <message>
        <source>What is not saved is safe only while Moldwright runs. %1</source>
        <translation>Was nicht gespeichert ist, ist nur sicher, solange Moldwright läuft. %1</translation>
    </message>
    <message>
        <source>%1 is open as it was, and is not saved.</source>
        <translation>%1 ist offen, wie es war, und nicht gespeichert.</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>not run</source>
        <translation>nicht gerechnet</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Variants of this part</source>
        <translation>Varianten dieses Teils</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Castable</source>
        <translation>Gießbar</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>Kleinste Schräge</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Farthest, mm</source>
        <translation>Größte Abw., mm</translation>
    </message>
    <message>
        <source>RMS, mm</source>
        <translation>RMS, mm</translation>
    </message>
    <message>
        <source>Filled, cm³</source>
        <translation>Gefüllt, cm³</translation>
    </message>
    <message>
        <source>Block, mm</source>
        <translation>Block, mm</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>This report is of variant {0}. Castable: proved in exact arithmetic. Strain is the root of the mean square over the surface of both principal stretches less 1. Farthest and RMS are distances between cast and part after the best rigid fit. The block is that of the mold with the variant&apos;s own settings.</source>
        <translation>Dieser Bericht gilt der Variante {0}. Gießbar: bewiesen in exakter Arithmetik. Dehnung ist die Wurzel aus dem mittleren Quadrat beider Hauptstreckungen weniger 1 über die Oberfläche. Größte Abweichung und RMS sind Abstände zwischen Guss und Teil nach bester starrer Einpassung. Der Block ist der der Form mit den Einstellungen der Variante.</translation>
    </message>
    <message>
        <source>{0} January {1}</source>
        <translation>{0}. Januar {1}</translation>
    </message>
    <message>
        <source>{0} February {1}</source>
        <translation>{0}. Februar {1}</translation>
    </message>
    <message>
        <source>{0} March {1}</source>
        <translation>{0}. März {1}</translation>
    </message>
    <message>
        <source>{0} April {1}</source>
        <translation>{0}. April {1}</translation>
    </message>
    <message>
        <source>{0} May {1}</source>
        <translation>{0}. Mai {1}</translation>
    </message>
    <message>
        <source>{0} June {1}</source>
        <translation>{0}. Juni {1}</translation>
    </message>
    <message>
        <source>{0} July {1}</source>
        <translation>{0}. Juli {1}</translation>
    </message>
    <message>
        <source>{0} August {1}</source>
        <translation>{0}. August {1}</translation>
    </message>
    <message>
        <source>{0} September {1}</source>
        <translation>{0}. September {1}</translation>
    </message>
    <message>
        <source>{0} October {1}</source>
        <translation>{0}. Oktober {1}</translation>
    </message>
    <message>
        <source>{0} November {1}</source>
        <translation>{0}. November {1}</translation>
    </message>
    <message>
        <source>{0} December {1}</source>
        <translation>{0}. Dezember {1}</translation>
    </message>
    <message>
        <source>own choice</source>
        <translation>eigene Wahl</translation>
    </message>
    <message>
        <source>open mold generators</source>
        <translation>freie Formgeneratoren</translation>
    </message>
    <message>
        <source>shop practice</source>
        <translation>Werkstattpraxis</translation>
    </message>
    <message>
        <source>Spout, diameter</source>
        <translation>Anguss, Durchmesser</translation>
    </message>
    <message>
        <source>Spout, at the block’s face</source>
        <translation>Anguss, an der Blockfläche</translation>
    </message>
    <message>
        <source>Gate, width</source>
        <translation>Anschnitt, Breite</translation>
    </message>
    <message>
        <source>Channels, draft</source>
        <translation>Kanäle, Schräge</translation>
    </message>
    <message>
        <source>Neck of the spout</source>
        <translation>Hals des Angusses</translation>
    </message>
    <message>
        <source>Vents, at the narrowest</source>
        <translation>Entlüftungen, engste Stelle</translation>
    </message>
    <message>
        <source>gravity pour, shop practice</source>
        <translation>Schwerkraftguss, Werkstattpraxis</translation>
    </message>
    <message>
        <source>Air that may stay</source>
        <translation>Luft, die bleiben darf</translation>
    </message>
    <message>
        <source>Keys, diameter</source>
        <translation>Zapfen, Durchmesser</translation>
    </message>
    <message>
        <source>Keys, height</source>
        <translation>Zapfen, Höhe</translation>
    </message>
    <message>
        <source>Keys, clearance</source>
        <translation>Zapfen, Spiel</translation>
    </message>
    <message>
        <source>Keys, draft at least</source>
        <translation>Zapfen, Schräge mindestens</translation>
    </message>
    <message>
        <source>First key larger by</source>
        <translation>Erster Zapfen größer um</translation>
    </message>
    <message>
        <source>Wedge slits, depth</source>
        <translation>Keilschlitze, Tiefe</translation>
    </message>
    <message>
        <source>mold makers</source>
        <translation>Formenbauer</translation>
    </message>
    <message>
        <source>Wedge slits, width</source>
        <translation>Keilschlitze, Breite</translation>
    </message>
    <message>
        <source>Wedge slits, height in each half</source>
        <translation>Keilschlitze, Höhe je Hälfte</translation>
    </message>
    <message>
        <source>Bolt holes, diameter</source>
        <translation>Schraubenlöcher, Durchmesser</translation>
    </message>
    <message>
        <source>M6, ISO 273 medium</source>
        <translation>M6, ISO 273 mittel</translation>
    </message>
    <message>
        <source>Bolt holes, steel to faces</source>
        <translation>Schraubenlöcher, Stahl nach außen</translation>
    </message>
    <message>
        <source>Bolt holes, steel to the rest</source>
        <translation>Schraubenlöcher, Stahl zum Übrigen</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>open mold generators, 1.5 to 25 mm</source>
        <translation>freie Formgeneratoren, 1,5 bis 25 mm</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>as the wall</source>
        <translation>wie die Wand</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Decke</translation>
    </message>
    <message>
        <source>Sizes round up to</source>
        <translation>Maße aufgerundet auf</translation>
    </message>
    <message>
        <source>Cavity pressure</source>
        <translation>Druck in der Kavität</translation>
    </message>
    <message>
        <source>no source: set it to your process</source>
        <translation>ohne Quelle: nach Ihrem Prozess setzen</translation>
    </message>
    <message>
        <source>Clamp allowance</source>
        <translation>Zuschlag zur Schließkraft</translation>
    </message>
    <message>
        <source>1.1 to 1.2 in shop practice</source>
        <translation>1,1 bis 1,2 in der Werkstattpraxis</translation>
    </message>
    <message>
        <source>Mix allowance</source>
        <translation>Zuschlag zur Gießmasse</translation>
    </message>
    <message>
        <source>Ejector holes, diameter</source>
        <translation>Auswerferlöcher, Durchmesser</translation>
    </message>
    <message>
        <source>length {0}</source>
        <translation>Länge {0}</translation>
    </message>
    <message>
        <source>width {0}</source>
        <translation>Breite {0}</translation>
    </message>
    <message>
        <source>depth {0}</source>
        <translation>Tiefe {0}</translation>
    </message>
    <message>
        <source>height {0}</source>
        <translation>Höhe {0}</translation>
    </message>
    <message>
        <source>{0} into half 1</source>
        <translation>{0} in Hälfte 1</translation>
    </message>
    <message>
        <source>{0} into half 2</source>
        <translation>{0} in Hälfte 2</translation>
    </message>
    <message>
        <source>clearance {0}</source>
        <translation>Spiel {0}</translation>
    </message>
    <message>
        <source>Way from the spout to each cavity</source>
        <translation>Weg vom Anguss zu jeder Kavität</translation>
    </message>
    <message>
        <source>equally long, {0}</source>
        <translation>gleich lang, {0}</translation>
    </message>
    <message>
        <source>neck ⌀ {0}</source>
        <translation>Hals ⌀ {0}</translation>
    </message>
    <message>
        <source>lean {0}</source>
        <translation>Neigung {0}</translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>Kavität</translation>
    </message>
    <message>
        <source>Cavity, mirrored</source>
        <translation>Kavität, gespiegelt</translation>
    </message>
    <message>
        <source>Spout</source>
        <translation>Anguss</translation>
    </message>
    <message>
        <source>Spout through half 1</source>
        <translation>Anguss durch Hälfte 1</translation>
    </message>
    <message>
        <source>Runner</source>
        <translation>Verteiler</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Anschnitt</translation>
    </message>
    <message>
        <source>Vent</source>
        <translation>Entlüftung</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Zapfen</translation>
    </message>
    <message>
        <source>Wedge slit</source>
        <translation>Keilschlitz</translation>
    </message>
    <message>
        <source>Bolt hole</source>
        <translation>Schraubenloch</translation>
    </message>
    <message>
        <source>Ejector hole in half 1</source>
        <translation>Auswerferloch in Hälfte 1</translation>
    </message>
    <message>
        <source>Ejector hole in half 2</source>
        <translation>Auswerferloch in Hälfte 2</translation>
    </message>
    <message>
        <source>Air that stays</source>
        <translation>Luft, die bleibt</translation>
    </message>
    <message>
        <source>Overflow</source>
        <translation>Überlauf</translation>
    </message>
    <message>
        <source>Insert pocket in both halves</source>
        <translation>Einlegertasche in beiden Hälften</translation>
    </message>
    <message>
        <source>Insert pocket in half 1</source>
        <translation>Einlegertasche in Hälfte 1</translation>
    </message>
    <message>
        <source>Insert pocket in half 2</source>
        <translation>Einlegertasche in Hälfte 2</translation>
    </message>
    <message>
        <source>Plaque on half 1</source>
        <translation>Schild auf Hälfte 1</translation>
    </message>
    <message>
        <source>Plaque on half 2</source>
        <translation>Schild auf Hälfte 2</translation>
    </message>
    <message>
        <source>overflow</source>
        <translation>Überlauf</translation>
    </message>
    <message>
        <source>overflow&apos;s channel</source>
        <translation>Kanal des Überlaufs</translation>
    </message>
    <message>
        <source>pocket</source>
        <translation>Einlegertasche</translation>
    </message>
    <message>
        <source>plaque</source>
        <translation>Schild</translation>
    </message>
    <message>
        <source>the right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>the left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>half 1</source>
        <translation>Hälfte 1</translation>
    </message>
    <message>
        <source>half 2</source>
        <translation>Hälfte 2</translation>
    </message>
    <message>
        <source>half 1 and the right</source>
        <translation>Hälfte 1 und rechts</translation>
    </message>
    <message>
        <source>half 1 and the left</source>
        <translation>Hälfte 1 und links</translation>
    </message>
    <message>
        <source>half 2 and the left</source>
        <translation>Hälfte 2 und links</translation>
    </message>
    <message>
        <source>half 2 and the right</source>
        <translation>Hälfte 2 und rechts</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>the back and the right</source>
        <translation>hinten rechts</translation>
    </message>
    <message>
        <source>the back and the left</source>
        <translation>hinten links</translation>
    </message>
    <message>
        <source>the front and the left</source>
        <translation>vorn links</translation>
    </message>
    <message>
        <source>the front and the right</source>
        <translation>vorn rechts</translation>
    </message>
    <message>
        <source>cavity</source>
        <translation>Kavität</translation>
    </message>
    <message>
        <source>spout</source>
        <translation>Anguss</translation>
    </message>
    <message>
        <source>runner</source>
        <translation>Verteiler</translation>
    </message>
    <message>
        <source>gate</source>
        <translation>Anschnitt</translation>
    </message>
    <message>
        <source>vent</source>
        <translation>Entlüftung</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Zapfen</translation>
    </message>
    <message>
        <source>slit</source>
        <translation>Keilschlitz</translation>
    </message>
    <message>
        <source>bolt hole</source>
        <translation>Schraubenloch</translation>
    </message>
    <message>
        <source>ejector hole</source>
        <translation>Auswerferloch</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>Cavities and features</source>
        <translation>Kavitäten und Merkmale</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Merkmal</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Each</source>
        <translation>Je</translation>
    </message>
    <message>
        <source>Not castable yet</source>
        <translation>Noch nicht gießbar</translation>
    </message>
    <message>
        <source>No cast has been made of this part. Required draft {0}.</source>
        <translation>Aus diesem Teil wurde noch kein Guss gemacht. Verlangte Schräge {0}.</translation>
    </message>
    <message>
        <source>No mold yet</source>
        <translation>Noch keine Form</translation>
    </message>
    <message>
        <source>The cast is there, its mold could not be built. Required draft {0}.</source>
        <translation>Der Guss ist da, seine Form konnte nicht gebaut werden. Verlangte Schräge {0}.</translation>
    </message>
    <message>
        <source>Castable. The mold opens.</source>
        <translation>Gießbar. Die Form öffnet sich.</translation>
    </message>
    <message>
        <source>Proved on the written halves for every face: draft {0} or more, where {1} is required.</source>
        <translation>Bewiesen an den geschriebenen Hälften für jede Fläche: Schräge {0} oder mehr, wo {1} verlangt ist.</translation>
    </message>
    <message>
        <source>The mold is not proved to open. Open items are on page 2.</source>
        <translation>Dass die Form sich öffnet, ist nicht bewiesen. Offene Punkte stehen auf Seite 2.</translation>
    </message>
    <message>
        <source>none, factor 1</source>
        <translation>keine, Faktor 1</translation>
    </message>
    <message>
        <source>{0} %, {1}: factor {2}</source>
        <translation>{0} %, {1}: Faktor {2}</translation>
    </message>
    <message>
        <source>x {0}, y {1}, z {2} %, {3}: factors {4}, {5}, {6}</source>
        <translation>x {0}, y {1}, z {2} %, {3}: Faktoren {4}, {5}, {6}</translation>
    </message>
    <message>
        <source>Smallest steel</source>
        <translation>Kleinster Stahl</translation>
    </message>
    <message>
        <source>Smallest steel, {0} to {1}</source>
        <translation>Kleinster Stahl, {0} bis {1}</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Read from</source>
        <translation>Gelesen aus</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>millimetres, degrees</source>
        <translation>Millimeter, Grad</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Schwindung</translation>
    </message>
    <message>
        <source>no mold yet</source>
        <translation>noch keine Form</translation>
    </message>
    <message>
        <source>Parting plane and directions</source>
        <translation>Trennebene und Richtungen</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation>keine gewählt</translation>
    </message>
    <message>
        <source>{0} to {1}</source>
        <translation>{0} zu {1}</translation>
    </message>
    <message>
        <source>Plane, n · x = o</source>
        <translation>Ebene, n · x = o</translation>
    </message>
    <message>
        <source>Direction 1</source>
        <translation>Richtung 1</translation>
    </message>
    <message>
        <source>Direction 2</source>
        <translation>Richtung 2</translation>
    </message>
    <message>
        <source>Tilted while it is filled</source>
        <translation>Beim Füllen geneigt</translation>
    </message>
    <message>
        <source>Better tilted while it is filled</source>
        <translation>Beim Füllen besser geneigt</translation>
    </message>
    <message>
        <source>{0}° towards {1}
air: {2} mm³, upright {3} mm³</source>
        <translation>{0}° zu {1}
Luft: {2} mm³, aufrecht {3} mm³</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Volume of the part</source>
        <translation>Volumen des Teils</translation>
    </message>
    <message>
        <source>Cavity, as cut</source>
        <translation>Kavität, wie geschnitten</translation>
    </message>
    <message>
        <source>Mix, with 10 % allowance</source>
        <translation>Gießmasse mit 10 % Zuschlag</translation>
    </message>
    <message>
        <source>Projected area in the plane</source>
        <translation>Projizierte Fläche in der Ebene</translation>
    </message>
    <message>
        <source>Clamp force, {0} bar × 1.1</source>
        <translation>Schließkraft, {0} bar × 1,1</translation>
    </message>
    <message>
        <source>Mold, closed</source>
        <translation>Form, geschlossen</translation>
    </message>
    <message>
        <source>Kept from the part</source>
        <translation>Vom Teil erhalten</translation>
    </message>
    <message>
        <source>Mean deviation, after best fit</source>
        <translation>Mittlere Abweichung, eingepasst</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>Volume, cast over part</source>
        <translation>Volumen, Guss zu Teil</translation>
    </message>
    <message>
        <source>Filled in</source>
        <translation>Gefüllt</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Opens along, mold’s frame</source>
        <translation>Öffnet entlang (Form)</translation>
    </message>
    <message>
        <source>Mold half 1</source>
        <translation>Formhälfte 1</translation>
    </message>
    <message>
        <source>Mold half 2</source>
        <translation>Formhälfte 2</translation>
    </message>
    <message>
        <source>The cast is closed, manifold and outward</source>
        <translation>Der Guss ist geschlossen, mannigfaltig und nach außen gerichtet</translation>
    </message>
    <message>
        <source>Each direction leaves the parting plane on its side</source>
        <translation>Jede Richtung verlässt die Trennebene auf ihrer Seite</translation>
    </message>
    <message>
        <source>Every face has a draft of {0} or more, in exact arithmetic</source>
        <translation>Jede Fläche hat {0} Schräge oder mehr, in exakter Arithmetik</translation>
    </message>
    <message>
        <source>No face lies across the parting plane</source>
        <translation>Keine Fläche liegt über der Trennebene quer</translation>
    </message>
    <message>
        <source>The parting line is simple and nested, seen along both directions</source>
        <translation>Die Trennlinie ist einfach und verschachtelt, entlang beider Richtungen gesehen</translation>
    </message>
    <message>
        <source>The cast does not cross itself</source>
        <translation>Der Guss durchdringt sich nicht</translation>
    </message>
    <message>
        <source>Both halves are closed, in one piece, and free to move at any distance</source>
        <translation>Beide Hälften sind geschlossen, aus einem Stück und in jedem Abstand frei beweglich</translation>
    </message>
    <message>
        <source>{0}: shape changed by {1}, no limit</source>
        <translation>{0}: Form um {1} geändert, ohne Grenze</translation>
    </message>
    <message>
        <source>{0}: shape changed by {1}, {2} allowed</source>
        <translation>{0}: Form um {1} geändert, {2} erlaubt</translation>
    </message>
    <message>
        <source>{0}: shape changed by {1}, more than the {2} allowed.</source>
        <translation>{0}: Form um {1} geändert, mehr als die erlaubten {2}.</translation>
    </message>
    <message>
        <source>Red below {0}: {1}</source>
        <translation>Rot unter {0}: {1}</translation>
    </message>
    <message>
        <source>As read</source>
        <translation>Wie gelesen</translation>
    </message>
    <message>
        <source>Mean deviation {0} mm</source>
        <translation>Mittlere Abweichung {0} mm</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keiner</translation>
    </message>
    <message>
        <source>Build the mold.</source>
        <translation>Die Form bauen.</translation>
    </message>
    <message>
        <source>Make the part castable, then build the mold.</source>
        <translation>Das Teil gießbar machen, dann die Form bauen.</translation>
    </message>
    <message>
        <source>Mold design report</source>
        <translation>Bericht zur Form</translation>
    </message>
    <message>
        <source>file %1</source>
        <translation>Datei %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>below −15°</source>
        <translation>unter −15°</translation>
    </message>
    <message>
        <source>−15 to −5°</source>
        <translation>−15 bis −5°</translation>
    </message>
    <message>
        <source>−5 to 0°</source>
        <translation>−5 bis 0°</translation>
    </message>
    <message>
        <source>0 to %1°</source>
        <translation>0 bis %1°</translation>
    </message>
    <message>
        <source>%1 to 3°</source>
        <translation>%1 bis 3°</translation>
    </message>
    <message>
        <source>3 to 10°</source>
        <translation>3 bis 10°</translation>
    </message>
    <message>
        <source>10° and more</source>
        <translation>10° und mehr</translation>
    </message>
    <message>
        <source>Half %1</source>
        <translation>Hälfte %1</translation>
    </message>
    <message>
        <source>worst %1°, mean %2°</source>
        <translation>kleinste %1°, Mittel %2°</translation>
    </message>
    <message>
        <source>%1° required</source>
        <translation>%1° verlangt</translation>
    </message>
    <message>
        <source>Cast</source>
        <translation>Guss</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Schräge</translation>
    </message>
    <message>
        <source>Scale below, dark is bad</source>
        <translation>Skala unten, dunkel ist schlecht</translation>
    </message>
    <message>
        <source>Draft, area in cm² per 5°</source>
        <translation>Schräge, Fläche in cm² je 5°</translation>
    </message>
    <message>
        <source>Part and cast</source>
        <translation>Teil und Guss</translation>
    </message>
    <message>
        <source>Mold</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Half 2 left, half 1 right, parting faces up</source>
        <translation>Hälfte 2 links, Hälfte 1 rechts, Trennflächen oben</translation>
    </message>
    <message>
        <source>Not a simulation of filling, warpage or cooling.
Open items: %1.</source>
        <translation>Keine Simulation von Füllung, Verzug oder Abkühlung.
Offene Punkte: %1.</translation>
    </message>
    <message>
        <source>%1, see page 2</source>
        <translation>%1, siehe Seite 2</translation>
    </message>
    <message>
        <source>Important regions, each after its own best fit</source>
        <translation>Wichtige Bereiche, jeder für sich eingepasst</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Open items</source>
        <translation>Offene Punkte</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <source>Drawn by</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>Approved by</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Mold and proof</source>
        <translation>Form und Beweis</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
    <message>
        <source>Each half along its own direction, the cast between</source>
        <translation>Jede Hälfte entlang ihrer Richtung, der Guss dazwischen</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Stahl</translation>
    </message>
    <message>
        <source>Behind the walls, in mm; too thin is red</source>
        <translation>Hinter den Wänden, in mm; zu dünn ist rot</translation>
    </message>
    <message>
        <source>Certificate, on the written halves</source>
        <translation>Zertifikat, an den geschriebenen Hälften</translation>
    </message>
    <message>
        <source>Proved in exact arithmetic on the coordinates as they stand in the files. The proof speaks of rigid motion along the two directions; it is not a simulation of filling, warpage, cooling or friction.</source>
        <translation>Bewiesen in exakter Arithmetik an den Koordinaten, wie sie in den Dateien stehen. Der Beweis gilt der starren Bewegung entlang der beiden Richtungen; er ist keine Simulation von Füllung, Verzug, Abkühlung oder Reibung.</translation>
    </message>
    <message>
        <source>Defaults used</source>
        <translation>Verwendete Vorgaben</translation>
    </message>
    <message>
        <source>Features of the mold</source>
        <translation>Merkmale der Form</translation>
    </message>
    <message>
        <source>Defaults used for them</source>
        <translation>Dafür verwendete Vorgaben</translation>
    </message>
    <message>
        <source>To be known</source>
        <translation>Zu beachten</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>The report {0} could not be written. Choose another folder or free some space.</source>
        <translation>Der Bericht {0} konnte nicht geschrieben werden. Wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>nicht gewählt</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>Kavitäten</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>Revision</translation>
    </message>
    <message>
        <source>Taken from the material</source>
        <translation>Vom Material übernommen</translation>
    </message>
</context>
<context>
    <name>SteelPaint</name>
    <message>
        <source>Steel</source>
        <translation>Stahl</translation>
    </message>
    <message>
        <source>below %1, the least asked for</source>
        <translation>unter %1, dem geforderten Mindestmaß</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Wird gemessen</translation>
    </message>
    <message>
        <source>Shown on the halves: build the mold, or choose it.</source>
        <translation>Zu sehen an den Hälften: Form bauen oder auswählen.</translation>
    </message>
    <message>
        <source>behind the walls, thinnest %1</source>
        <translation>hinter den Wänden, am dünnsten %1</translation>
    </message>
</context>
<context>
    <name>RefusalPages</name>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Crowded edges</source>
        <translation>Überbelegte Kanten</translation>
    </message>
    <message>
        <source>Touching points</source>
        <translation>Berührpunkte</translation>
    </message>
    <message>
        <source>One-sided places</source>
        <translation>Einseitige Stellen</translation>
    </message>
    <message>
        <source>Faces without area</source>
        <translation>Flächen ohne Inhalt</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Durchdringungen</translation>
    </message>
    <message>
        <source>Closed surfaces inside</source>
        <translation>Eingeschlossene Flächen</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <translation>Loch %1</translation>
    </message>
    <message>
        <source>Crowded edge %1</source>
        <translation>Überbelegte Kante %1</translation>
    </message>
    <message>
        <source>Touching point %1</source>
        <translation>Berührpunkt %1</translation>
    </message>
    <message>
        <source>One-sided place %1</source>
        <translation>Einseitige Stelle %1</translation>
    </message>
    <message>
        <source>Face without area %1</source>
        <translation>Fläche ohne Inhalt %1</translation>
    </message>
    <message>
        <source>Crossing %1</source>
        <translation>Durchdringung %1</translation>
    </message>
    <message>
        <source>Closed surface inside %1</source>
        <translation>Eingeschlossene Fläche %1</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 Kanten</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 Flächen</translation>
    </message>
    <message>
        <source>No volume</source>
        <translation>Kein Volumen</translation>
    </message>
    <message>
        <source>Ways out</source>
        <translation>Auswege</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>X, Y, Z</source>
        <translation>X, Y, Z</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Lengths are those of the file.</source>
        <translation>Längen sind die der Datei.</translation>
    </message>
    <message>
        <source>Needs a sound mesh</source>
        <translation>Braucht ein heiles Netz</translation>
    </message>
    <message>
        <source>Cannot be cast yet</source>
        <translation>Noch nicht gießbar</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>unbrauchbar</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Read, and not ready for a mold.</source>
        <translation>Gelesen, aber nicht bereit für eine Form.</translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Manifold</source>
        <translation>Mannigfaltig</translation>
    </message>
    <message>
        <source>Faces look outward</source>
        <translation>Flächen schauen nach außen</translation>
    </message>
    <message>
        <source>Pairs that cross</source>
        <translation>Paare, die sich schneiden</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Mended while reading</source>
        <translation>Beim Lesen ausgebessert</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Mesh problems</source>
        <translation>Mängel des Netzes</translation>
    </message>
    <message>
        <source>Repair fills holes, splits and drops what too many faces share, and makes faces anew where they cross; where that does not help, a closed skin about the surface. Messages tell what was done.</source>
        <translation>Reparieren füllt Löcher, trennt und entfernt, was zu viele Flächen teilen, und macht Flächen neu, wo sie sich kreuzen; wo das nicht hilft, eine geschlossene Haut um die Oberfläche. Die Meldungen sagen, was geschah.</translation>
    </message>
    <message>
        <source>Or mend the mesh in the program that made it and write the file again; then read it again here. What was open before is as it was.</source>
        <translation>Oder beheben Sie das Netz in dem Programm, das es erzeugt hat, und schreiben Sie die Datei neu; lesen Sie sie dann hier erneut. Was zuvor offen war, ist unverändert.</translation>
    </message>
</context>
<context>
    <name>ChosenFeatures</name>
    <message>
        <source>%1 features of the mold</source>
        <translation>%1 Elemente der Form</translation>
    </message>
    <message>
        <source>Each is placed on its own; these are given back together.</source>
        <translation>Jedes steht für sich; gemeinsam werden sie dem Programm überlassen.</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Gewählt</translation>
    </message>
</context>
<context>
    <name>moldwright::QuantitySpinBox</name>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
</context>
<context>
    <name>moldwright::PinOffers</name>
    <message>
        <source>Looking for pins</source>
        <translation>Heftpunkte suchen</translation>
    </message>
    <message>
        <source>Take a suggested pin</source>
        <translation>Vorgeschlagenen Heftpunkt annehmen</translation>
    </message>
    <message>
        <source>Pin the ends of limbs</source>
        <translation>Enden von Gliedern anheften</translation>
    </message>
    <message>
        <source>Take suggested pins</source>
        <translation>Vorgeschlagene Heftpunkte nehmen</translation>
    </message>
</context>
<context>
    <name>moldwright::OpeningBar</name>
    <message>
        <source>How far the mold is open</source>
        <translation>Wie weit die Form offen ist</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>öffnet sich</translation>
    </message>
    <message>
        <source>apart</source>
        <translation>auseinander</translation>
    </message>
    <message>
        <source>turning over</source>
        <translation>klappt auf</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>nebeneinander</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
</context>
<context>
    <name>moldwright::SteelTable</name>
    <message>
        <source>Steel between features</source>
        <translation>Stahl zwischen Merkmalen</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Zwischen</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Stahl</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>The steel between the features of the mold, once it is built or they are placed.</source>
        <translation>Der Stahl zwischen den Merkmalen der Form, sobald sie gebaut ist oder diese platziert sind.</translation>
    </message>
</context>
<context>
    <name>MaterialPages</name>
    <message>
        <source>Not chosen</source>
        <translation>Nicht gewählt</translation>
    </message>
    <message>
        <source>%1, as in this project</source>
        <translation>%1, wie in diesem Projekt</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Sets shrink, its formula, density and the depth of vents; all can be changed below.</source>
        <translation>Setzt Schwindung, ihre Formel, Dichte und die Tiefe der Entlüftungen; alles lässt sich unten ändern.</translation>
    </message>
    <message>
        <source>Draft here</source>
        <translation>Schräge hier</translation>
    </message>
    <message>
        <source>And what is usual for the material.</source>
        <translation>Und was für das Material üblich ist.</translation>
    </message>
    <message>
        <source>Choose a material first.</source>
        <translation>Wählen Sie zuerst ein Material.</translation>
    </message>
    <message>
        <source>Take the material's draft</source>
        <translation>Schräge des Materials übernehmen</translation>
    </message>
</context>
<context>
    <name>moldwright::MaterialForm</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Process</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>%1, range</source>
        <translation>%1, Bereich</translation>
    </message>
    <message>
        <source>%1, source</source>
        <translation>%1, Quelle</translation>
    </message>
    <message>
        <source>%1, status</source>
        <translation>%1, Verlässlichkeit</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Verlässlichkeit</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Schwindung</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Schräge</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Vents' depth</source>
        <translation>Entlüftungstiefe</translation>
    </message>
    <message>
        <source>In the parting plane, both halves together; 0: as their width asks.</source>
        <translation>In der Trennebene, beide Hälften zusammen; 0: wie ihre Breite es verlangt.</translation>
    </message>
    <message>
        <source>Made larger by</source>
        <translation>Vergrößert um</translation>
    </message>
    <message>
        <source>Made &amp;larger by</source>
        <translation>Ver&amp;größert um</translation>
    </message>
    <message>
        <source>N&amp;otes</source>
        <translation>A&amp;nmerkungen</translation>
    </message>
    <message>
        <source>S&amp;ealing</source>
        <translation>V&amp;ersiegelung</translation>
    </message>
    <message>
        <source>&amp;Release agent</source>
        <translation>&amp;Trennmittel</translation>
    </message>
    <message>
        <source>&amp;Filling</source>
        <translation>&amp;Füllen</translation>
    </message>
    <message>
        <source>Se&amp;tting</source>
        <translation>Er&amp;härten</translation>
    </message>
    <message>
        <source>Source of these</source>
        <translation>Quelle hierzu</translation>
    </message>
</context>
<context>
    <name>moldwright::MaterialDialog</name>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>A material of your own, with the values of the one that is chosen.</source>
        <translation>Ein eigenes Material mit den Werten des gewählten.</translation>
    </message>
    <message>
        <source>Yours. A project keeps the values it was given; choose the material there anew to have these.</source>
        <translation>Ihr eigenes. Ein Projekt behält die Werte, die es bekam; wählen Sie das Material dort neu, um diese zu haben.</translation>
    </message>
    <message>
        <source>Comes with the program. What you change is kept as your own.</source>
        <translation>Kommt mit dem Programm. Was Sie ändern, wird als Ihr eigenes behalten.</translation>
    </message>
    <message>
        <source>As &amp;before</source>
        <translation>Wie &amp;vorher</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Take the values again that come with the program.</source>
        <translation>Wieder die Werte nehmen, die mit dem Programm kommen.</translation>
    </message>
    <message>
        <source>Forget this material of yours.</source>
        <translation>Dieses eigene Material vergessen.</translation>
    </message>
    <message>
        <source>%1, own</source>
        <translation>%1, eigenes</translation>
    </message>
</context>
<context>
    <name>TrayPages</name>
    <message>
        <source>Part %1</source>
        <translation>Teil %1</translation>
    </message>
    <message>
        <source>%1 cavities: %2</source>
        <translation>%1 Kavitäten: %2</translation>
    </message>
    <message>
        <source>All places of the layout that the other parts leave.</source>
        <translation>Alle Plätze der Anordnung, die die anderen Teile übrig lassen.</translation>
    </message>
    <message>
        <source>How many cavities the mold has of it.</source>
        <translation>Wie viele Kavitäten die Form davon hat.</translation>
    </message>
    <message>
        <source>Two halves around the cast.</source>
        <translation>Zwei Hälften um den Guss.</translation>
    </message>
    <message>
        <source>Parts in the mold</source>
        <translation>Teile in der Form</translation>
    </message>
    <message>
        <source>The cast of this project, in its mold.</source>
        <translation>Der Guss dieses Projekts, in seiner Form.</translation>
    </message>
    <message>
        <source>A further part in the same mold.</source>
        <translation>Ein weiteres Teil in derselben Form.</translation>
    </message>
    <message>
        <source>In the mold</source>
        <translation>In der Form</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>Kavitäten</translation>
    </message>
    <message>
        <source>Its cast</source>
        <translation>Sein Guss</translation>
    </message>
    <message>
        <source>Read from</source>
        <translation>Gelesen aus</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>Kleinste Schräge</translation>
    </message>
    <message>
        <source>Along its own directions; in the mold it leaves along those of the first part.</source>
        <translation>Entlang der eigenen Richtungen; in der Form verlässt es sie entlang denen des ersten Teils.</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Größe, mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>this project</source>
        <translation>diesem Projekt</translation>
    </message>
</context>
</TS>
