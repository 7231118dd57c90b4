package org.pendant.desktop.io;

import javax.swing.JToggleButton;

/** Level button: a switch that shows what it is told to and asks before it changes. */
@SuppressWarnings("serial") // never written to a stream
final class LevelButton extends JToggleButton {

  LevelButton(LevelIcon icon, Runnable toggle) {
    setIcon(icon.of(false));
    setSelectedIcon(icon.of(true));
    putClientProperty("JButton.buttonType", "toolBarButton");
    putClientProperty(
        "FlatLaf.style",
        "toolbar.selectedBackground: null; toolbar.margin: 2,2,2,2; margin: 2,2,2,2");
    addActionListener(event -> toggle.run());
  }

  /** Looks like a light while it cannot be used. */
  void showLampWhenDisabled() {
    setDisabledIcon(LevelIcon.LAMP.of(false));
    setDisabledSelectedIcon(LevelIcon.LAMP.of(true));
  }

  void allow(boolean enabled) {
    if (isEnabled() != enabled) {
      setEnabled(enabled);
    }
  }

  void showLevel(boolean level) {
    if (isSelected() != level) {
      setSelected(level);
    }
  }
}
