package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import javax.swing.JToggleButton;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.settings.Settings;

/**
 * Follow switch: whether the line that runs is kept in sight. People who scroll leave it; the next
 * start brings them back.
 */
final class FollowSwitch {
  private static final String SETTING = "script.follow";

  private final Settings settings;
  private final JToggleButton button = new JToggleButton(SvgIcon.of("tool/follow", 16));
  private boolean on;

  FollowSwitch(Settings settings) {
    this.settings = settings;
    button.setName("script-follow");
    button.setToolTipText(text("followKeepsTheLineThatRuns"));
    button.getAccessibleContext().setAccessibleName(text("followTheProgram"));
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.addActionListener(event -> choose(button.isSelected()));
    again();
  }

  JToggleButton button() {
    return button;
  }

  /** Whether the line is kept in sight now. */
  boolean on() {
    return on;
  }

  /** People turn it on or off, for later starts as well. */
  void choose(boolean wanted) {
    settings.put(SETTING, String.valueOf(wanted));
    set(wanted);
  }

  /** People have scrolled away. */
  void left() {
    set(false);
  }

  /** A program starts. */
  void again() {
    set(settings.get(SETTING).map(Boolean::parseBoolean).orElse(true));
  }

  private void set(boolean wanted) {
    on = wanted;
    button.setSelected(wanted);
  }
}
