package org.pendant.window;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.KeyStroke;

/** Mouse and keys of the display, on an American keyboard. */
final class Hands {
  private static final String SHIFTED = "~!@#$%^&*()_+{}|:\"<>?";
  private static final int STEPS = 10;
  private static final String PLAIN = "`1234567890-=[]\\;',./";

  /** A view that moves all the time may keep a window busy for ever. */
  private static final Duration MAX_WAITED = Duration.ofMillis(500);

  /** Looks for somebody whom keys reach; then they are pressed all the same. */
  private static final int MAX_LOOKS = 20;

  private final Robot robot;

  /** One of its own, since a robot that waits does nothing else. */
  private final Robot waiting;

  Hands() throws AWTException {
    robot = new Robot();
    waiting = new Robot();
  }

  /** Presses the left button at the middle of {@code place} and keeps it down. */
  void hold(Rectangle place) {
    robot.mouseMove((int) place.getCenterX(), (int) place.getCenterY());
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
  }

  /** Moves to the middle of {@code place}, in steps as a hand does. */
  void moveTo(Rectangle place) {
    Point start = MouseInfo.getPointerInfo().getLocation();
    for (int i = 1; i <= STEPS; i++) {
      robot.mouseMove(
          start.x + (int) ((place.getCenterX() - start.x) * i / STEPS),
          start.y + (int) ((place.getCenterY() - start.y) * i / STEPS));
    }
  }

  /** Presses the left button at the middle of {@code place} and lets it go. */
  void click(Rectangle place) {
    hold(place);
    release();
  }

  /** Lets the button go. */
  void release() {
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
  }

  /**
   * Presses and releases keys, such as {@code control shift P}, when they go somewhere: a button
   * that is disabled gives the focus away a moment later, and until then keys are lost.
   */
  void press(String keys) throws InterruptedException {
    for (int i = 0; i < MAX_LOOKS && !Places.dispatched(Hands::keysArrive); i++) {
      settle();
    }
    KeyStroke stroke = KeyStroke.getKeyStroke(keys);
    if (stroke == null) {
      throw new IllegalArgumentException("no such keys: " + keys);
    }
    List<Integer> held =
        Stream.of(
                InputEvent.CTRL_DOWN_MASK, KeyEvent.VK_CONTROL,
                InputEvent.SHIFT_DOWN_MASK, KeyEvent.VK_SHIFT,
                InputEvent.ALT_DOWN_MASK, KeyEvent.VK_ALT)
            .toList();
    for (int i = 0; i < held.size(); i += 2) {
      if ((stroke.getModifiers() & held.get(i)) != 0) {
        robot.keyPress(held.get(i + 1));
      }
    }
    robot.keyPress(stroke.getKeyCode());
    robot.keyRelease(stroke.getKeyCode());
    for (int i = 0; i < held.size(); i += 2) {
      if ((stroke.getModifiers() & held.get(i)) != 0) {
        robot.keyRelease(held.get(i + 1));
      }
    }
  }

  private static boolean keysArrive() {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    return owner != null && owner.isEnabled() && owner.isShowing();
  }

  /**
   * Types ASCII text; a line feed is Enter. Behind that the keys may belong to another component,
   * and Java cannot tell keys of one millisecond apart.
   */
  void type(String text) throws InterruptedException {
    for (int i = 0; i < text.length(); i++) {
      type(text.charAt(i));
      if (text.charAt(i) == '\n') {
        settle();
      }
    }
  }

  private void type(char character) {
    int shifted = SHIFTED.indexOf(character);
    boolean shift = shifted >= 0 || Character.isUpperCase(character);
    char key = shifted >= 0 ? PLAIN.charAt(shifted) : Character.toLowerCase(character);
    int code = KeyEvent.getExtendedKeyCodeForChar(key);
    if (shift) {
      robot.keyPress(KeyEvent.VK_SHIFT);
    }
    robot.keyPress(code);
    robot.keyRelease(code);
    if (shift) {
      robot.keyRelease(KeyEvent.VK_SHIFT);
    }
  }

  /**
   * Waits until the display has handed over all that these hands did, and the window has dealt with
   * it: until then it shows, and gives the keys to, what was there before.
   */
  void settle() throws InterruptedException {
    Thread idle = Thread.ofPlatform().daemon().start(waiting::waitForIdle);
    if (!idle.join(MAX_WAITED)) {
      Places.dispatched(() -> true);
    }
  }

  /** What the display shows at {@code place}. */
  BufferedImage look(Rectangle place) {
    return robot.createScreenCapture(place);
  }
}
