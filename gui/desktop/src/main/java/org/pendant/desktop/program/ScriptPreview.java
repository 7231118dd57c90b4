package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.awt.BorderLayout;
import java.util.Optional;
import javax.swing.JPanel;
import org.pendant.desktop.editor.Execution;
import org.pendant.desktop.editor.ScriptPad;
import org.pendant.language.signature.Catalogue;
import org.pendant.project.program.script.GeneratedScript;

/**
 * Script preview: the script that the tree generates, with the lines of the selected node marked,
 * and the line that runs.
 */
@SuppressWarnings("serial") // never written to a stream
final class ScriptPreview extends JPanel {
  private final ScriptPad pad;
  private transient GeneratedScript shown = GeneratedScript.EMPTY;
  private long key;

  ScriptPreview(Catalogue catalogue) {
    super(new BorderLayout());
    setName("program-script-preview");
    pad = new ScriptPad(catalogue, false, text -> {});
    pad.text().setName("program-script-text");
    pad.text().getAccessibleContext().setAccessibleName(text("generatedScript"));
    add(pad);
  }

  /** Shows a script and marks a node of it; 0 for none. */
  void show(GeneratedScript script, long node) {
    boolean other = node != key || !script.equals(shown);
    pad.show(script.text());
    shown = script;
    key = node;
    if (other) {
      Optional<GeneratedScript.NodeLines> place = shown.of(key);
      pad.mark(
          place.map(GeneratedScript.NodeLines::first).orElse(0),
          place.map(GeneratedScript.NodeLines::last).orElse(0));
    }
  }

  /** Marks where the program is, and keeps it in sight if {@code follow} is true. */
  void setExecution(Execution execution, boolean follow) {
    pad.setExecution(execution, follow);
  }
}
