package org.pendant.kit.action;

import static org.pendant.kit.action.KeyTexts.text;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import javax.swing.KeyStroke;

/** Key style: how keys are pressed together and written on a kind of computer. */
enum KeyStyle {
  /** Ctrl is the key of menus; names are joined by a plus sign. */
  PC(text("ctrl"), text("alt"), text("shift"), text("meta"), "+"),
  /** Cmd is the key of menus; signs stand in the order of Apple's own menus. */
  MAC("\u2303", "\u2325", "\u21e7", "\u2318", "");

  /** With Cmd these belong to macOS itself. */
  private static final Set<Integer> NOT_WITH_COMMAND =
      Set.of(KeyEvent.VK_SPACE, KeyEvent.VK_TAB, KeyEvent.VK_H, KeyEvent.VK_M);

  private final String control;
  private final String alt;
  private final String shift;
  private final String meta;
  private final String join;

  KeyStyle(String control, String alt, String shift, String meta, String join) {
    this.control = control;
    this.alt = alt;
    this.shift = shift;
    this.meta = meta;
    this.join = join;
  }

  /** The style of the system of this name, as the property {@code os.name} has it. */
  static KeyStyle of(String osName) {
    return osName.toLowerCase(Locale.ROOT).startsWith("mac") ? MAC : PC;
  }

  /** Keys as actions come with them, with this computer's key of menus instead of control. */
  String keys(String keys) {
    KeyStroke stroke = KeyStroke.getKeyStroke(keys);
    if (this == PC
        || stroke == null
        || (stroke.getModifiers() & InputEvent.CTRL_DOWN_MASK) == 0
        || NOT_WITH_COMMAND.contains(stroke.getKeyCode())) {
      return keys;
    }
    int others = stroke.getModifiers() & (InputEvent.ALT_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK);
    return KeyText.keys(
        KeyStroke.getKeyStroke(stroke.getKeyCode(), others | InputEvent.META_DOWN_MASK));
  }

  /** As menus show it, such as {@code Ctrl+Shift+P}. */
  String shown(KeyStroke stroke) {
    List<String> parts = new ArrayList<>();
    int modifiers = stroke.getModifiers();
    addIf(parts, modifiers, InputEvent.CTRL_DOWN_MASK, control);
    addIf(parts, modifiers, InputEvent.ALT_DOWN_MASK, alt);
    addIf(parts, modifiers, InputEvent.SHIFT_DOWN_MASK, shift);
    addIf(parts, modifiers, InputEvent.META_DOWN_MASK, meta);
    parts.add(KeyText.name(stroke.getKeyCode()));
    return String.join(join, parts);
  }

  private static void addIf(List<String> parts, int modifiers, int mask, String name) {
    if ((modifiers & mask) != 0) {
      parts.add(name);
    }
  }
}
