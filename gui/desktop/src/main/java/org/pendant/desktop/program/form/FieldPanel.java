package org.pendant.desktop.program.form;

import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.theme.Palette;

/** Field panel: a control with what is wrong with it below. */
@SuppressWarnings("serial") // never written to a stream
final class FieldPanel extends JPanel {
  private final FormText problem;
  private final transient Supplier<String> own;
  private String found = "";

  /**
   * A panel around a control.
   *
   * @param own what the control itself refuses, which is said first
   */
  FieldPanel(JComponent control, String name, Supplier<String> own) {
    super(new MigLayout("insets 0, gap 0 2, wrap 1, hidemode 3", "[grow, fill]"));
    this.own = own;
    setOpaque(false);
    problem = new FormText(name + "-problem", Palette::error).keepingRoom();
    add(control, "wmin 0");
    add(problem, "growx, width 0:10:");
  }

  /** Says what was found by others; returns what is said now. */
  String say(String problemFound) {
    found = problemFound;
    return refresh();
  }

  /** Says what is wrong now. */
  String refresh() {
    String said = own.get().isEmpty() ? found : own.get();
    problem.say(said);
    return said;
  }
}
