package org.pendant.desktop.editor;

import java.awt.Rectangle;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.AnalysisSchedule;
import org.pendant.desktop.editor.text.RichText;
import org.pendant.kit.layout.FloatingPanel;
import org.pendant.language.service.Hover;

/** Name help: shows below the line what is known about the name at the caret. */
final class NameHelp {
  private final ScriptArea area;
  private final AnalysisSchedule schedule;
  private final JLabel text = new JLabel();
  private final FloatingPanel panel;

  NameHelp(ScriptArea area, AnalysisSchedule schedule) {
    this.area = area;
    this.schedule = schedule;
    text.setName("name-help");
    text.setBorder(BorderFactory.createEmptyBorder(6, 10, 6, 10));
    panel = new FloatingPanel(area, text);
    area.addCaretListener(event -> hide());
    area.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            if (event.getKeyCode() == KeyEvent.VK_ESCAPE && panel.visible()) {
              hide();
              event.consume();
            }
          }
        });
  }

  void hide() {
    panel.hide();
  }

  /** Shows it; {@code otherwise} runs where there is no name, and in no call. */
  void show(Runnable otherwise) {
    schedule.whenCurrent(
        analysed -> {
          int caret = area.getCaretPosition();
          Optional<Hover> known = known(analysed, caret);
          if (known.isEmpty() || !area.isShowing()) {
            otherwise.run();
            return;
          }
          text.setText(RichText.of(known.get()));
          Rectangle line = area.place(caret);
          panel.show(line, false);
        });
  }

  /** About the name that the caret touches, or the function in whose brackets it is. */
  private static Optional<Hover> known(AnalysedText analysed, int caret) {
    return analysed
        .hover(caret)
        .or(() -> caret > 0 ? analysed.hover(caret - 1) : Optional.empty())
        .or(
            () ->
                analysed
                    .signatureHelp(caret)
                    .flatMap(help -> analysed.hover(analysed.span(help.callee()).start())));
  }
}
