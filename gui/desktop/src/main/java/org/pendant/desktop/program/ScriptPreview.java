package org.pendant.desktop.program;

import java.util.Optional;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultHighlighter;
import org.pendant.kit.layout.CodeArea;
import org.pendant.kit.theme.Palette;
import org.pendant.project.program.script.GeneratedScript;

/**
 * Script preview: the script that the tree generates, with the lines of the selected node marked.
 */
@SuppressWarnings("serial") // never written to a stream
final class ScriptPreview extends JScrollPane {
  private final JTextArea text = new CodeArea();
  private transient GeneratedScript shown = GeneratedScript.EMPTY;
  private long key;

  ScriptPreview() {
    setName("program-script-preview");
    text.setName("program-script-text");
    text.setEditable(false);
    text.getAccessibleContext().setAccessibleName("Generated script");
    setViewportView(text);
    updateUI();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (text != null) {
      text.setBackground(UIManager.getColor("TextArea.background"));
      mark();
    }
  }

  /** Shows a script and marks a node of it; 0 for none. */
  void show(GeneratedScript script, long node) {
    if (!script.text().equals(shown.text())) {
      text.setText(script.text());
      text.setCaretPosition(0);
    }
    boolean other = node != key || !script.equals(shown);
    shown = script;
    key = node;
    if (other) {
      mark();
    }
  }

  private void mark() {
    text.getHighlighter().removeAllHighlights();
    Optional<GeneratedScript.NodeLines> place = shown.of(key);
    if (place.isEmpty() || place.get().last() > text.getLineCount()) {
      return;
    }
    try {
      int start = text.getLineStartOffset(place.get().first() - 1);
      int end = text.getLineEndOffset(place.get().last() - 1);
      text.getHighlighter()
          .addHighlight(start, end, new DefaultHighlighter.DefaultHighlightPainter(Palette.mark()));
      text.setCaretPosition(start);
    } catch (BadLocationException e) {
      throw new IllegalStateException("the lines of a node are not in the script", e);
    }
  }
}
