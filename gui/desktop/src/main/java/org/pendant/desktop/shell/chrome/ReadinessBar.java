package org.pendant.desktop.shell.chrome;

import static org.pendant.desktop.shell.chrome.ChromeTexts.text;

import java.awt.Color;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.command.Command;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ArmReadiness;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Badge;
import org.pendant.kit.theme.Palette;

/** Readiness bar: whether the arm is ready, and the button that makes it so. */
@SuppressWarnings("serial") // never written to a stream
final class ReadinessBar extends JPanel {
  /** Longer than between the clicks of a double click, ms. */
  private static final int DOUBLE_CLICK_MS = 600;

  private final Badge light = new Badge("readiness", text("whetherTheArmIsReadyFor"));
  private final JButton remedy = new JButton(Glyph.POWER.icon(16));
  private transient ArmReadiness shown;
  private boolean worded = true;

  ReadinessBar(ControllerState state, Consumer<Command> send) {
    super(new MigLayout("insets 0, gap 8", "[][]", "[center]"));
    shown = ArmReadiness.of(state);
    remedy.setName("readiness-remedy");
    // "Unlock" is "Switch off" a moment later: the second click of a double click powered the arm
    // off
    remedy.setMultiClickThreshhold(DOUBLE_CLICK_MS);
    remedy.addActionListener(event -> shown.command().ifPresent(send));
    add(light, "wmin pref");
    add(remedy, "wmin pref, hidemode 3");
    apply();
  }

  void refresh(ControllerState state) {
    ArmReadiness now = ArmReadiness.of(state);
    if (!now.equals(shown)) {
      shown = now;
      apply();
    }
    light.show(shown.text(), color(shown.light()));
  }

  /** What stands there: the width depends on it. */
  String words() {
    return shown.text() + shown.remedy();
  }

  /** Shows the button with its words, or with its icon alone. */
  void showRemedy(boolean whole) {
    worded = whole;
    apply();
  }

  private void apply() {
    light.show(shown.text(), color(shown.light()));
    light.setToolTipText(shown.hint());
    remedy.setText(worded ? shown.remedy() : "");
    remedy.setVisible(!shown.remedy().isEmpty());
    remedy.setEnabled(shown.command().isPresent());
    remedy.setToolTipText(Messages.told(shown.remedy(), shown.hint()));
    remedy.getAccessibleContext().setAccessibleName(shown.remedy());
    remedy.getAccessibleContext().setAccessibleDescription(shown.hint());
  }

  private static Supplier<Color> color(ArmReadiness.Light light) {
    return switch (light) {
      case READY -> Palette::ok;
      case WAITING -> Palette::warning;
      case OFF -> Palette::quiet;
      case STOPPED -> Palette::error;
    };
  }
}
