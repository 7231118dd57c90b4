package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Map;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.InnerScroll;
import org.pendant.kit.layout.ShownFocus;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Palette;

/**
 * Rules card: what happens by itself, as text, checked while it is typed and taken with Ctrl+Enter
 * or when the focus leaves. What cannot be taken stays to be mended.
 */
final class RulesCard {
  private static final int ROWS = 8;

  private final SceneDraft draft;
  private final TitledCard card = new TitledCard("rules", text("rules"), "[grow, fill]");
  private final JTextArea area = new JTextArea(ROWS, 30);
  private final Remark problem = new Remark("cell-rules-problem", Palette::error);
  private ProgramDocument document;
  private String shown = "";
  private boolean showing;

  RulesCard(SceneDraft draft) {
    this.draft = draft;
    document = draft.document();
    TitledCard.named(area, "cell-rules", text("rulesOfTheCellAsJson"));
    area.setFont(UIManager.getFont("monospaced.font"));
    area.getDocument().addDocumentListener(new Typed(this::check));
    area.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            take();
          }
        });
    key("control ENTER", this::take);
    key("ESCAPE", () -> write(shown));
    Remark help = new Remark("cell-rules-help", Palette::quiet);
    help.say(text("whatHappensByItselfAsDocs"));
    JScrollPane scroll = InnerScroll.of(new JScrollPane(area));
    ShownFocus.of(area, scroll);
    card.add(scroll, "grow, hmin 80");
    card.add(problem, Remark.LAYOUT);
    card.add(help, Remark.LAYOUT);
  }

  private void key(String keys, Runnable run) {
    area.getInputMap().put(KeyStroke.getKeyStroke(keys), keys);
    area.getActionMap()
        .put(
            keys,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
              }
            });
  }

  JComponent component() {
    return card;
  }

  /** Shows the draft; what is typed and not taken stays, unless it is for another scene. */
  void show() {
    String now = Equipment.rules(draft.equipment());
    boolean other = draft.document() != document;
    boolean typed = !area.getText().strip().equals(shown);
    boolean changed = !now.equals(shown);
    document = draft.document();
    shown = now;
    if (other || (changed && !typed)) {
      write(now);
    } else {
      check();
    }
  }

  private void write(String text) {
    showing = true;
    area.setText(text);
    area.setCaretPosition(0);
    showing = false;
    problem.say("");
  }

  private void check() {
    if (!showing) {
      String why = refusal();
      problem.say(why.isEmpty() ? "" : text("notTakenYetEscBringsBack", why));
    }
  }

  private String refusal() {
    return Equipment.rulesRefusal(draft.scene(), draft.equipment(), area.getText());
  }

  private void take() {
    if (refusal().isEmpty()) {
      Map<String, String> next = Equipment.with(draft.equipment(), area.getText());
      shown = area.getText().strip();
      draft.setEquipment(next);
    }
  }
}
