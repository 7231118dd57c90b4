package org.pendant.desktop.editor;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import org.fife.ui.rtextarea.RTextScrollPane;
import org.pendant.desktop.editor.text.LineColours;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Palette;
import org.pendant.language.signature.Catalogue;

/**
 * Script pad: a few lines of URScript in their colours, inside of something else; Tab leaves it.
 */
@SuppressWarnings("serial") // never written to a stream
public final class ScriptPad extends JPanel {
  private final ScriptArea area;
  private final RTextScrollPane scroll;
  private boolean showing;

  /**
   * An empty pad.
   *
   * @param editable whether people can type in it
   * @param typed handed the text after each change by people
   */
  public ScriptPad(Catalogue catalogue, boolean editable, Consumer<String> typed) {
    super(new BorderLayout());
    LineColours colours = new LineColours(catalogue);
    area = new ScriptArea(colours, Optional::empty, key -> true);
    area.setCodeFoldingEnabled(false);
    area.setEditable(editable);
    area.setLineWrap(editable);
    area.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    area.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    area.setHighlightCurrentLine(false);
    area.getDocument()
        .addDocumentListener(
            new Typed(
                () -> {
                  if (!showing) {
                    typed.accept(area.getText());
                  }
                }));
    scroll = new RTextScrollPane(area, true);
    add(scroll);
    applyTheme();
  }

  /** What holds the text. */
  public JComponent text() {
    return area;
  }

  /** Shows a text; one that is shown already keeps its caret. */
  public void show(String text) {
    if (!area.getText().equals(text)) {
      showing = true;
      int caret = area.getCaretPosition();
      area.setText(text);
      area.setCaretPosition(Math.min(caret, text.length()));
      area.discardAllEdits();
      showing = false;
    }
  }

  /** How many lines are in sight. */
  public void setRows(int rows) {
    if (area.getRows() != rows) {
      area.setRows(rows);
      revalidate();
    }
  }

  private void applyTheme() {
    EditorTheme.apply(area, scroll);
    scroll.setBorder(BorderFactory.createLineBorder(Palette.line()));
    area.themeChanged();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (scroll != null) {
      // The parts of this panel get their new look after it.
      EventQueue.invokeLater(this::applyTheme);
    }
  }
}
