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
import org.pendant.language.service.SignatureHelp;

/**
 * Signature popup: shows over the line what the call around the caret takes, and which argument is
 * being written.
 */
final class SignaturePopup {
  private final ScriptArea area;
  private final AnalysisSchedule schedule;
  private final JLabel text = new JLabel();
  private final FloatingPanel overlay;

  SignaturePopup(ScriptArea area, AnalysisSchedule schedule) {
    this.area = area;
    this.schedule = schedule;
    text.setName("signature");
    text.setBorder(BorderFactory.createEmptyBorder(6, 10, 6, 10));
    overlay = new FloatingPanel(area, text);
    area.addCaretListener(
        event -> {
          if (overlay.visible()) {
            schedule.whenRested(this::show);
          }
        });
    area.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            if (event.getKeyCode() == KeyEvent.VK_ESCAPE && overlay.visible()) {
              hide();
              event.consume();
            }
          }
        });
  }

  void hide() {
    overlay.hide();
  }

  void typed(char c) {
    if ((c == '(' || c == ',') && !schedule.isLong()) {
      schedule.whenDue(this::show);
    }
  }

  /** Shows it, or takes it away outside calls. */
  void request() {
    schedule.whenCurrent(this::show);
  }

  private void show(AnalysedText analysed) {
    int caret = area.getCaretPosition();
    Optional<SignatureHelp> help = analysed.signatureHelp(caret);
    if (help.isEmpty() || !area.isShowing()) {
      hide();
      return;
    }
    text.setText(RichText.of(help.get()));
    Rectangle callee = area.place(analysed.span(help.get().callee()).start());
    Rectangle line = area.place(caret);
    overlay.show(new Rectangle(callee.x, line.y, callee.width, line.height), true);
  }
}
