package org.pendant.desktop.editor;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.HierarchyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.text.BadLocationException;
import org.fife.ui.rtextarea.RTextScrollPane;
import org.pendant.desktop.editor.text.LineColours;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.LookFollower;
import org.pendant.kit.theme.Palette;
import org.pendant.language.signature.Catalogue;

/** Script pad: lines of URScript in their colours, inside of something else; Tab leaves it. */
@SuppressWarnings("serial") // never written to a stream
public final class ScriptPad extends JPanel implements LookFollower {
  private final ScriptArea area;
  private final RTextScrollPane scroll;
  private final transient List<Object> marked = new ArrayList<>();
  private boolean showing;
  private int markedFirst;
  private int markedLast;
  private int running;
  private boolean following;

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
    area.addHierarchyListener(
        event -> {
          boolean shown = (event.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0;
          if (shown && area.isShowing() && !marked.isEmpty()) {
            EventQueue.invokeLater(() -> reveal(markedFirst, markedLast));
          }
        });
    scroll
        .getViewport()
        .addComponentListener(
            new ComponentAdapter() {
              @Override
              public void componentResized(ComponentEvent event) {
                if (following) {
                  reveal(running, running);
                }
              }
            });
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

  /**
   * Marks lines, counted from 1, and shows the first of them in the middle unless all can be seen;
   * none if the first is 0.
   */
  public void mark(int first, int last) {
    marked.forEach(area::removeLineHighlight);
    marked.clear();
    markedFirst = first;
    markedLast = Math.min(last, area.getLineCount());
    if (first < 1 || first > area.getLineCount()) {
      return;
    }
    try {
      for (int line = first; line <= markedLast; line++) {
        marked.add(area.addLineHighlight(line - 1, Palette.mark()));
      }
    } catch (BadLocationException e) {
      throw new IllegalStateException("lines " + first + " to " + last + " are in the text", e);
    }
    // A text that has just been set is laid out before.
    EventQueue.invokeLater(() -> reveal(markedFirst, markedLast));
  }

  /** Marks where a program is, and keeps it in sight if {@code follow} is true. */
  public void setExecution(Execution execution, boolean follow) {
    following = follow;
    boolean moved = execution.line() != running;
    running = execution.line();
    area.setExecution(running <= area.getLineCount() ? execution : Execution.NONE);
    // An area marks the caret's line again when nothing runs.
    area.setHighlightCurrentLine(false);
    if (follow && moved && running > 0 && running <= area.getLineCount()) {
      reveal(running, running);
    }
  }

  private void reveal(int first, int last) {
    if (!area.isShowing() || first < 1 || last > area.getLineCount()) {
      return;
    }
    Rectangle place = area.place(area.line(first).start());
    place.add(area.place(area.line(last).start()));
    Rectangle seen = area.getVisibleRect();
    if (seen.y <= place.y && place.y + place.height <= seen.y + seen.height) {
      return;
    }
    int above = Math.max(0, (seen.height - place.height) / 2);
    int y = Math.max(0, place.y - above);
    area.scrollRectToVisible(new Rectangle(0, y, 1, seen.height));
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
    area.setHighlightCurrentLine(false);
    if (!marked.isEmpty()) {
      mark(markedFirst, markedLast);
    }
  }

  @Override
  public void lookChanged() {
    applyTheme();
  }
}
