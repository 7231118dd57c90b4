package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dialog.ModalityType;
import java.awt.Font;
import java.awt.Rectangle;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultHighlighter.DefaultHighlightPainter;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.theme.Palette;
import org.pendant.language.source.ByteText;
import org.pendant.recording.RecordedProgram;

/**
 * Recorded text: the text of a program as it was when it ran, in a window of its own; it cannot be
 * changed.
 */
public final class RecordedText {
  private final JTextArea area = new JTextArea();
  private Optional<JDialog> dialog = Optional.empty();
  private Optional<RecordedProgram> shown = Optional.empty();
  private int line;

  /** Nothing is shown yet. */
  public RecordedText() {
    area.setName("recorded-text");
    area.setEditable(false);
    area.getAccessibleContext().setAccessibleName(text("theTextThatRanReadOnly"));
  }

  /** Shows the window. */
  void open(Component parent) {
    JDialog window = dialog.orElseGet(() -> make(parent));
    dialog = Optional.of(window);
    window.setVisible(true);
    mark();
  }

  private JDialog make(Component parent) {
    JDialog window =
        new JDialog(
            SwingUtilities.getWindowAncestor(parent),
            text("theTextThatRan"),
            ModalityType.MODELESS);
    window.setName("recorded-text-window");
    area.setFont(new Font(Font.MONOSPACED, Font.PLAIN, area.getFont().getSize()));
    window.add(new JScrollPane(area));
    window.setSize(UIScale.scale(640), UIScale.scale(480));
    window.setLocationRelativeTo(window.getOwner());
    window
        .getRootPane()
        .registerKeyboardAction(
            event -> window.setVisible(false),
            KeyStroke.getKeyStroke("ESCAPE"),
            JComponent.WHEN_IN_FOCUSED_WINDOW);
    return window;
  }

  /** Follows the moment that people look at. */
  void show(Optional<RecordedProgram> program, Optional<ControllerState> past) {
    int now = past.map(state -> state.program().line()).orElse(0);
    if (program.equals(shown) && now == line) {
      return;
    }
    if (program.isPresent() && !program.equals(shown)) {
      area.setText(ByteText.decoded(program.get().source().text()));
      area.setCaretPosition(0);
    }
    shown = program;
    line = now;
    mark();
    if (program.isEmpty()) {
      dialog.ifPresent(window -> window.setVisible(false));
    }
  }

  private void mark() {
    area.getHighlighter().removeAllHighlights();
    String name = shown.map(text -> ByteText.decoded(text.source().name())).orElse("");
    dialog.ifPresent(window -> window.setTitle(text("theTextOfThatRanLine", name, line)));
    if (line < 1 || line > area.getLineCount()) {
      return;
    }
    try {
      int begin = area.getLineStartOffset(line - 1);
      area.getHighlighter()
          .addHighlight(
              begin, area.getLineEndOffset(line - 1), new DefaultHighlightPainter(Palette.mark()));
      var place = area.modelToView2D(begin);
      if (place != null) {
        area.scrollRectToVisible(new Rectangle(place.getBounds()));
      }
    } catch (BadLocationException e) {
      throw new IllegalStateException("line " + line + " of " + area.getLineCount(), e);
    }
  }
}
