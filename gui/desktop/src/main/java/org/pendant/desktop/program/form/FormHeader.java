package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;

/** Form header: what kind of node it is, what that does, and what is wrong with it as a whole. */
@SuppressWarnings("serial") // never written to a stream
final class FormHeader extends JPanel {
  private final JLabel title = new JLabel();
  private final FormText about = new FormText("form-about", Palette::quiet);
  private final FormText problems = new FormText("form-problems", Palette::error).keepingRoom();
  private final FormText warnings = new FormText("form-warnings", Palette::warning).keepingRoom();
  private final FormText suppressed = new FormText("form-suppressed", Palette::warning);
  private final JButton again = new JButton(text("useItAgain"));

  /**
   * A header.
   *
   * @param use has a suppressed node take part again
   */
  FormHeader(Runnable use) {
    super(new MigLayout("insets 0 4 0 4, gap 0 4, wrap 1, hidemode 3", "[grow, fill]"));
    setOpaque(false);
    title.setName("form-title");
    title.putClientProperty("FlatLaf.styleClass", "h2");
    TitledCard.compact(again);
    TitledCard.named(again, "form-use-again", text("letTheNodeTakePartIn"));
    again.addActionListener(event -> use.run());
    add(title, "wmin 0");
    for (FormText each : List.of(about, suppressed)) {
      add(each, "growx, width 0:10:");
    }
    add(again, "growx 0");
    add(problems, "growx, width 0:10:");
    add(warnings, "growx, width 0:10:");
  }

  void show(String kind, String text) {
    title.setText(kind);
    title.setToolTipText(kind);
    about.say(text);
  }

  /** Another node: room is kept only for what is said about one. */
  void giveRoomBack() {
    problems.giveRoomBack();
    warnings.giveRoomBack();
  }

  void setSuppressed(boolean now) {
    suppressed.say(now ? text("suppressedThisNodeAndAllBelow") : "");
    again.setVisible(now);
  }

  void setProblems(List<String> messages) {
    problems.say(String.join("\n", messages));
  }

  void setWarnings(List<String> messages) {
    warnings.say(String.join("\n", messages));
  }
}
