package org.pendant.kit.action;

import static org.pendant.kit.action.KeyTexts.text;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Map;
import javax.swing.KeyStroke;

/** Key text: keys as people and settings write them. */
public final class KeyText {
  private static final KeyStyle STYLE = KeyStyle.of(System.getProperty("os.name", ""));

  private static final Map<Integer, String> NAMES =
      Map.ofEntries(
          Map.entry(KeyEvent.VK_ESCAPE, text("esc")),
          Map.entry(KeyEvent.VK_ENTER, text("enter")),
          Map.entry(KeyEvent.VK_SPACE, text("space")),
          Map.entry(KeyEvent.VK_DELETE, text("del")),
          Map.entry(KeyEvent.VK_BACK_SPACE, text("backspace")),
          Map.entry(KeyEvent.VK_TAB, text("tab")),
          Map.entry(KeyEvent.VK_PAGE_UP, text("pageUp")),
          Map.entry(KeyEvent.VK_PAGE_DOWN, text("pageDown")),
          Map.entry(KeyEvent.VK_LEFT, text("left")),
          Map.entry(KeyEvent.VK_RIGHT, text("right")),
          Map.entry(KeyEvent.VK_UP, text("up")),
          Map.entry(KeyEvent.VK_DOWN, text("down")),
          Map.entry(KeyEvent.VK_COMMA, ","),
          Map.entry(KeyEvent.VK_PERIOD, "."),
          Map.entry(KeyEvent.VK_PLUS, "+"),
          Map.entry(KeyEvent.VK_EQUALS, "="),
          Map.entry(KeyEvent.VK_MINUS, "-"),
          Map.entry(KeyEvent.VK_SLASH, "/"),
          Map.entry(KeyEvent.VK_BACK_SLASH, "\\"),
          Map.entry(KeyEvent.VK_SEMICOLON, ";"),
          Map.entry(KeyEvent.VK_QUOTE, "'"),
          Map.entry(KeyEvent.VK_OPEN_BRACKET, "["),
          Map.entry(KeyEvent.VK_CLOSE_BRACKET, "]"));

  private KeyText() {}

  /** Keys as a menu shows them, such as {@code Ctrl+Shift+P}; empty for none. */
  public static String shown(String keys) {
    KeyStroke stroke = KeyStroke.getKeyStroke(keys);
    return stroke == null ? "" : shown(stroke);
  }

  /** A key stroke as a menu shows it. */
  public static String shown(KeyStroke stroke) {
    return STYLE.shown(stroke);
  }

  /**
   * Keys with this computer's key of menus in place of control, such as {@code meta P} for {@code
   * control P} on macOS. {@link ActionTable} does so by itself; keys bound without it need this.
   */
  public static String ofMenus(String keys) {
    return STYLE.keys(keys);
  }

  static String name(int code) {
    boolean plain =
        (code >= KeyEvent.VK_0 && code <= KeyEvent.VK_9)
            || (code >= KeyEvent.VK_A && code <= KeyEvent.VK_Z);
    if (plain) {
      return String.valueOf((char) code);
    }
    String known = NAMES.get(code);
    return known == null ? KeyEvent.getKeyText(code) : known;
  }

  /** A key stroke as {@link Action#keys} has it, such as {@code ctrl shift P}. */
  public static String keys(KeyStroke stroke) {
    return stroke.toString().replace("pressed ", "");
  }

  /**
   * Whether a key can do an action: one that writes a character, or that moves around in texts and
   * lists, cannot while nothing is held with it.
   */
  public static boolean bindable(KeyStroke stroke) {
    int code = stroke.getKeyCode();
    boolean function =
        (code >= KeyEvent.VK_F1 && code <= KeyEvent.VK_F12)
            || (code >= KeyEvent.VK_F13 && code <= KeyEvent.VK_F24);
    int held = InputEvent.CTRL_DOWN_MASK | InputEvent.ALT_DOWN_MASK | InputEvent.META_DOWN_MASK;
    return function || (stroke.getModifiers() & held) != 0;
  }

  /** Whether a key is only there to be held with others. */
  public static boolean modifier(int keyCode) {
    return switch (keyCode) {
      case KeyEvent.VK_SHIFT,
          KeyEvent.VK_CONTROL,
          KeyEvent.VK_ALT,
          KeyEvent.VK_ALT_GRAPH,
          KeyEvent.VK_META ->
          true;
      default -> false;
    };
  }
}
