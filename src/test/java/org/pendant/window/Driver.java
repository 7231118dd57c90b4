package org.pendant.window;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.WindowEvent;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.RepaintManager;
import org.pendant.gui.shell.Desktop;

/**
 * The process that a window is in: opens the desktop, then does what each line of standard input
 * asks for and answers with a line of standard output, {@code ok} or {@code no} and a text.
 */
final class Driver {
  private final PaintGuard guard = new PaintGuard();
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
            Stream.of(arguments).map(Path::of).toList(), Optional.empty(), Optional.empty());
    Thread.ofPlatform().name("end").daemon().start(() -> endWith(desktop));
    BufferedReader requests =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    PrintStream replies = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    for (String line = requests.readLine(); line != null; line = requests.readLine()) {
      replies.println(driver.reply(line));
    }
    // The test has gone, and so has whoever could close the window.
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
    switch (verb) {
      case "press" -> hands.press(what);
      case "type" -> hands.type(what);
      case "hold" -> hands.hold(placeInView(what));
      case "release" -> hands.release();
      case "click" -> {
        hands.hold(placeInView(what));
        hands.release();
      }
      case "click-text" -> {
        hands.hold(dispatched(() -> Eyes.place(inside(what))));
        hands.release();
      }
      case "click-cell" -> {
        hands.hold(dispatched(() -> cell(what)));
        hands.release();
      }
      case "click-row" -> {
        hands.hold(row(what));
        hands.release();
      }
      case "drag-row" -> dragRow(what);
      case "drag" -> drag(what);
      case "choose" -> dispatched(() -> choose(what));
      case "close" -> dispatched(Driver::close);
      case "raise" -> dispatched(Driver::raise);
      case "size" -> dispatched(() -> size(what));
      case "picture" -> ImageIO.write(SmallPicture.of(hands.look(screen())), "png", new File(what));
      case "picture-of" -> {
        String[] words = what.split("=", 2);
        ImageIO.write(hands.look(place(words[0])), "png", new File(words[1]));
      }
      case "colours" -> {
        Rectangle seen = place(what);
        // a component that the window has not laid out yet shows nothing
        return seen.isEmpty() ? "0" : Long.toString(Eyes.colours(hands.look(seen)));
      }
      case "shows" -> {
        return dispatched(() -> Boolean.toString(Eyes.find(what).isPresent()));
      }
      case "enabled" -> {
        return dispatched(() -> Boolean.toString(find(what).isEnabled()));
      }
      case "selected" -> {
        return dispatched(
            () -> Boolean.toString(find(what) instanceof AbstractButton each && each.isSelected()));
      }
      case "focused" -> {
        return dispatched(() -> Boolean.toString(Eyes.focused(find(what))));
      }
      case "words" -> {
        return dispatched(() -> Eyes.words(find(what)));
      }
      case "brightness" -> {
        return Long.toString(Eyes.brightness(hands.look(place(what))));
      }
      case "whole" -> {
        return dispatched(() -> Boolean.toString(Eyes.whole(find(what))));
      }
      case "tabs" -> {
        return dispatched(() -> Eyes.tabs(find(what)));
      }
      case "named" -> {
        return dispatched(() -> Eyes.named(what));
      }
      case "nameless" -> {
        return dispatched(() -> Eyes.nameless(find(what)));
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
    Rectangle from =
        dispatched(
            () -> {
              String[] words = ends[0].split("=", 2);
              return Eyes.tab(find(words[0]), words[1]);
            });
    hands.hold(from);
    hands.moveTo(place(ends[1]));
    hands.release();
  }

  /** {@code list=text > list=text}: a row of a list or tree to just below another row. */
  private void dragRow(String what) throws InterruptedException {
    String[] ends = what.split(" > ", 2);
    hands.hold(row(ends[0]));
    Rectangle last = row(ends[1]);
    hands.moveTo(new Rectangle(last.x, last.y + last.height - 2, last.width, 1));
    hands.release();
  }

  /** {@code list=text}: brought into view, where it stands still. */
  private static Rectangle row(String what) throws InterruptedException {
    String[] words = what.split("=", 2);
    Callable<Rectangle> where = () -> Rows.place(find(words[0]), words[1]);
    Rectangle place = dispatched(where);
    for (Rectangle next = dispatched(where); !next.equals(place); next = dispatched(where)) {
      place = next;
    }
    return place;
  }

  /** As people scroll to what they want to click on, and wait until it stands still. */
  private static Rectangle placeInView(String name) throws InterruptedException {
    Rectangle place = scrolledTo(name);
    for (Rectangle next = scrolledTo(name); !next.equals(place); next = scrolledTo(name)) {
      place = next;
    }
    return place;
  }

  private static Rectangle scrolledTo(String name) throws InterruptedException {
    dispatched(
        () -> {
          if (find(name) instanceof JComponent inside) {
            inside.scrollRectToVisible(new Rectangle(inside.getSize()));
          }
          Toolkit.getDefaultToolkit().sync();
          return "";
        });
    return place(name);
  }

  private static Component find(String name) {
    return Eyes.find(name)
        .orElseThrow(() -> new IllegalArgumentException("nothing visible is named " + name));
  }

  /** {@code container=text}: for what has no stable name of its own. */
  private static Component inside(String what) {
    String[] words = what.split("=", 2);
    return Eyes.inside(find(words[0]), words[1])
        .orElseThrow(() -> new IllegalArgumentException("nothing reads " + words[1]));
  }

  /** {@code table=text}. */
  private static Rectangle cell(String what) {
    String[] words = what.split("=", 2);
    if (!(find(words[0]) instanceof JTable table)) {
      throw new IllegalArgumentException(words[0] + " is not a table");
    }
    return Eyes.cell(table, words[1])
        .orElseThrow(() -> new IllegalArgumentException("no cell reads " + words[1]));
  }

  private static Rectangle place(String name) throws InterruptedException {
    return dispatched(() -> Eyes.place(find(name)));
  }

  private static Rectangle screen() {
    return new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
  }

  /** {@code box=item}: what a combo box lists by arrow keys depends on what was chosen before. */
  private static String choose(String what) {
    String[] words = what.split("=", 2);
    switch (find(words[0])) {
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

  private static String close() {
    Frame frame = (Frame) find("pendant");
    frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING));
    return "";
  }

  private static String raise() {
    Frame frame = (Frame) find("pendant");
    Component last = frame.getMostRecentFocusOwner();
    (last == null ? frame : last).requestFocus();
    return "";
  }

  private static String size(String what) {
    String[] words = what.split("x", 2);
    find("pendant").setBounds(0, 0, Integer.parseInt(words[0]), Integer.parseInt(words[1]));
    return "";
  }

  private static <T> T dispatched(Callable<T> question) throws InterruptedException {
    FutureTask<T> task = new FutureTask<>(question);
    try {
      EventQueue.invokeAndWait(task);
      return task.get();
    } catch (ExecutionException e) {
      throw new IllegalArgumentException(e.getCause().getMessage(), e);
    } catch (InvocationTargetException e) {
      throw new IllegalStateException(e);
    }
  }
}
