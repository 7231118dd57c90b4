package org.pendant.window;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.WindowEvent;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JFrame;
import javax.swing.JTabbedPane;
import javax.swing.RepaintManager;
import org.pendant.command.service.SimulationWishes;
import org.pendant.desktop.shell.Desktop;

/**
 * The process that a window is in: opens the desktop, then does what each line of standard input
 * asks for and answers with a line of standard output, {@code ok} or {@code no} and a text.
 */
final class Driver {
  private final PaintGuard guard = new PaintGuard();
  private final TextRoom room = new TextRoom();
  private final Hands hands;

  private Driver() throws AWTException {
    hands = new Hands();
  }

  /** Serves requests until standard input or the desktop ends; arguments are programs to open. */
  public static void main(String[] arguments) throws AWTException, IOException {
    Driver driver = new Driver();
    RepaintManager.setCurrentManager(driver.guard);
    Desktop desktop =
        Desktop.open(
            Stream.of(arguments).map(Path::of).toList(),
            Optional.empty(),
            Optional.empty(),
            SimulationWishes.NONE);
    Thread.ofPlatform().name("end").daemon().start(() -> endWith(desktop));
    ProcessHandle.current()
        .parent()
        .ifPresent(
            tests -> Thread.ofPlatform().name("tests").daemon().start(() -> endAfter(tests)));
    BufferedReader requests =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    PrintStream replies = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    for (String line = requests.readLine(); line != null; line = requests.readLine()) {
      replies.println(driver.reply(line));
    }
    // The test has gone, and with it what could close the window.
    Runtime.getRuntime().halt(1);
  }

  /** The process ends when the desktop has been closed, as {@code ./pendant} does. */
  private static void endWith(Desktop desktop) {
    try {
      desktop.awaitClosed();
      Runtime.getRuntime().halt(0);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** A window that hangs does not read the end of its input. */
  private static void endAfter(ProcessHandle tests) {
    tests.onExit().join();
    Runtime.getRuntime().halt(1);
  }

  private String reply(String line) {
    String[] words = line.split("\t", 2);
    try {
      return "ok\t"
          + serve(words[0], words.length > 1 ? words[1].translateEscapes() : "")
              .replace("\\", "\\\\")
              .replace("\n", "\\n");
    } catch (IllegalArgumentException | IOException e) {
      return "no\t" + e.getMessage();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "no\tinterrupted";
    }
  }

  private String serve(String verb, String what) throws IOException, InterruptedException {
    if (acts(verb, what)) {
      // What is asked next is asked of a window that has dealt with it.
      hands.settle();
      return "";
    }
    return look(verb, what);
  }

  /** Does what changes the window; false when {@code verb} is nothing of that kind. */
  private boolean acts(String verb, String what) throws InterruptedException {
    switch (verb) {
      case "press" -> hands.press(what);
      case "type" -> hands.type(what);
      case "hold" -> hands.hold(Places.inView(what));
      case "release" -> hands.release();
      case "click" -> hands.click(Places.inView(what));
      case "click-text" -> hands.click(Places.button(what));
      case "click-cell" -> hands.click(Places.cell(what));
      case "click-row" -> hands.click(Places.row(what));
      case "drag-row" -> dragRow(what);
      case "drag" -> drag(what);
      case "choose" -> Places.dispatched(() -> choose(what));
      case "close" -> Places.dispatched(() -> close(what));
      case "raise" -> Places.dispatched(Driver::raise);
      case "size" -> Places.dispatched(() -> size(what));
      default -> {
        return false;
      }
    }
    return true;
  }

  private String look(String verb, String what) throws IOException, InterruptedException {
    switch (verb) {
      case "picture" -> ImageIO.write(SmallPicture.of(hands.look(screen())), "png", new File(what));
      case "picture-of" -> {
        String[] words = what.split("=", 2);
        ImageIO.write(hands.look(Places.of(words[0])), "png", new File(words[1]));
      }
      case "colours" -> {
        Rectangle seen = Places.of(what);
        // a component that the window has not laid out yet shows nothing
        return seen.isEmpty() ? "0" : Long.toString(Eyes.colours(hands.look(seen)));
      }
      case "shows" -> {
        return Places.dispatched(() -> Boolean.toString(Eyes.find(what).isPresent()));
      }
      case "place" -> {
        Rectangle at = Places.of(what);
        return at.x + "," + at.y;
      }
      case "enabled" -> {
        return Places.dispatched(() -> Boolean.toString(Places.find(what).isEnabled()));
      }
      case "selected" -> {
        return Places.dispatched(
            () ->
                Boolean.toString(
                    Places.find(what) instanceof AbstractButton each && each.isSelected()));
      }
      case "focused" -> {
        return Places.dispatched(() -> Boolean.toString(Eyes.focused(Places.find(what))));
      }
      case "words" -> {
        return Places.dispatched(() -> Eyes.words(Places.find(what)));
      }
      case "brightness" -> {
        return Long.toString(Eyes.brightness(hands.look(Places.of(what))));
      }
      case "whole" -> {
        return Places.dispatched(() -> Boolean.toString(Eyes.whole(Places.find(what))));
      }
      case "tabs" -> {
        return Places.dispatched(() -> Eyes.tabs(Places.find(what)));
      }
      case "named" -> {
        return Places.dispatched(() -> Eyes.named(what));
      }
      case "menus" -> {
        return Places.dispatched(() -> Eyes.menus((JFrame) Places.find("pendant")));
      }
      case "nameless" -> {
        return Places.dispatched(() -> Eyes.nameless(Places.find(what)));
      }
      case "use" -> {
        return Places.dispatched(() -> Choices.use(what));
      }
      case "use-of" -> {
        return Places.dispatched(() -> Choices.useOf(what));
      }
      case "select" -> {
        return Places.dispatched(() -> Choices.select(what));
      }
      case "choices" -> {
        return Places.dispatched(() -> Integer.toString(Choices.count(Places.find(what))));
      }
      case "items" -> {
        return Places.dispatched(() -> String.join("\n", Choices.items().keySet()));
      }
      case "cut" -> {
        return Places.dispatched(room::look);
      }
      case "large-menus" -> {
        return Places.dispatched(() -> room.menus((JFrame) Places.find("pendant")));
      }
      case "texts" -> {
        return Places.dispatched(room::count);
      }
      case "complaints" -> {
        return String.join("\n", guard.complaints());
      }
      default -> throw new IllegalArgumentException("no such request: " + verb);
    }
    return "";
  }

  /** {@code tabs=title > name}: a tab to the middle of a component. */
  private void drag(String what) throws InterruptedException {
    String[] ends = what.split(" > ", 2);
    hands.hold(Places.tab(ends[0]));
    hands.settle();
    hands.moveTo(Places.of(ends[1]));
    hands.settle();
    hands.release();
  }

  /** {@code list=text > list=text}: a row of a list or tree to just below another row. */
  private void dragRow(String what) throws InterruptedException {
    String[] ends = what.split(" > ", 2);
    hands.hold(Places.row(ends[0]));
    hands.settle();
    Rectangle last = Places.row(ends[1]);
    hands.moveTo(new Rectangle(last.x, last.y + last.height - 2, last.width, 1));
    hands.settle();
    hands.release();
  }

  private static Rectangle screen() {
    return new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
  }

  /** {@code box=item}: what a combo box lists by arrow keys depends on what was chosen before. */
  private static String choose(String what) {
    String[] words = what.split("=", 2);
    switch (Places.find(words[0])) {
      case JComboBox<?> box -> {
        for (int i = 0; i < box.getItemCount(); i++) {
          if (words[1].equals(box.getItemAt(i).toString())) {
            box.setSelectedIndex(i);
            return "";
          }
        }
      }
      case JTabbedPane tabs -> {
        int index = tabs.indexOfTab(words[1]);
        if (index >= 0) {
          tabs.setSelectedIndex(index);
          return "";
        }
      }
      default -> {}
    }
    throw new IllegalArgumentException(words[0] + " does not offer " + words[1]);
  }

  private static String close(String name) {
    Frame frame = (Frame) Places.find(name);
    frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING));
    return "";
  }

  private static String raise() {
    Frame frame = (Frame) Places.find("pendant");
    Component last = frame.getMostRecentFocusOwner();
    (last == null ? frame : last).requestFocus();
    return "";
  }

  private static String size(String what) {
    String[] words = what.split("x", 2);
    Places.find("pendant").setBounds(0, 0, Integer.parseInt(words[0]), Integer.parseInt(words[1]));
    return "";
  }
}
