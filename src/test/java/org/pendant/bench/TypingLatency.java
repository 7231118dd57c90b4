package org.pendant.bench;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import javax.swing.text.JTextComponent;
import org.pendant.desktop.shell.Desktop;

/**
 * How long the desktop takes for a key that is typed in the middle of a long program: from the key
 * to the end of the repainting that it causes, on the dispatch thread, with every panel there. It
 * needs a display, a virtual one will do.
 */
final class TypingLatency {
  private static final int KEYS = 500;
  private static final int WARM_UP_KEYS = 200;
  private static final int LINES = 5_000;
  private static final long NS_PER_US = 1_000;

  /** Lines as people type them: calls with completions, blocks, brackets, strings. */
  private static final String TYPED =
      """
      movej([0.1, -1.57, 1.57, 0, 0, 0], a=1.4, v=1.05)
      if total > 10 and done < repeat:
      textmsg("total is ", total)
      end
      total = total + steps[1] * sin(d2r(45.5)) # a note
      """;

  private final TimedQueue queue;
  private final JTextComponent text;

  private TypingLatency(TimedQueue queue, JTextComponent text) {
    this.queue = queue;
    this.text = text;
  }

  /**
   * Opens a desktop with settings of its own in another process, types there and prints a table.
   *
   * @param arguments none; or {@code here} and the lines of the program, in that other process
   */
  public static void main(String[] arguments) throws Exception {
    if (arguments.length == 2 && arguments[0].equals("here")) {
      measure(Integer.parseInt(arguments[1]));
      // The window would stay, and its process with it.
      Runtime.getRuntime().halt(0);
    }
    int lines = arguments.length == 1 ? Integer.parseInt(arguments[0]) : LINES;
    ProcessBuilder child =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "--enable-native-access=ALL-UNNAMED",
                "--sun-misc-unsafe-memory-access=allow",
                "-cp",
                System.getProperty("java.class.path"),
                TypingLatency.class.getName(),
                "here",
                Integer.toString(lines))
            .inheritIO();
    child
        .environment()
        .put("XDG_CONFIG_HOME", Files.createTempDirectory("pendant-typing").toString());
    int code = child.start().waitFor();
    if (code != 0) {
      throw new IOException("the window's process ended with " + code);
    }
  }

  private static void measure(int lines) throws Exception {
    TimedQueue queue = new TimedQueue();
    Toolkit.getDefaultToolkit().getSystemEventQueue().push(queue);
    Desktop.open();
    JTextComponent text = awaitText();
    TypingLatency latency = new TypingLatency(queue, text);
    latency.fill(program(lines));
    latency.type(WARM_UP_KEYS);
    queue.longestNs.set(0);
    Times times = latency.type(KEYS);
    print(lines, times, queue.longestNs.get());
  }

  private static String program(int lines) {
    int bytes = 20 * lines;
    String text = GeneratedProgram.ofBytes(bytes);
    while (text.lines().count() < lines) {
      bytes += lines;
      text = GeneratedProgram.ofBytes(bytes);
    }
    return text;
  }

  private static JTextComponent awaitText() throws Exception {
    for (int tries = 0; tries < 300; tries++) {
      Optional<Component> found = onDispatchThread(TypingLatency::findText);
      if (found.isPresent()) {
        return (JTextComponent) found.get();
      }
      TimeUnit.MILLISECONDS.sleep(100);
    }
    throw new IOException("no window with a script came");
  }

  /** Finds the editor; brings its screen to the front first, by the key for it. */
  private static Optional<Component> findText() {
    for (Window window : Window.getWindows()) {
      Optional<Component> button = find(window, "rail-script");
      if (button.isPresent() && button.get() instanceof javax.swing.AbstractButton rail) {
        rail.doClick(0);
        return find(window, "script-text").filter(Component::isShowing);
      }
    }
    return Optional.empty();
  }

  private static Optional<Component> find(Container in, String name) {
    for (Component each : in.getComponents()) {
      if (name.equals(each.getName())) {
        return Optional.of(each);
      }
      if (each instanceof Container inner) {
        Optional<Component> found = find(inner, name);
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }

  private void fill(String program) throws Exception {
    onDispatchThread(
        () -> {
          text.setText(program);
          int middle = program.indexOf("\n", program.indexOf("total = ", program.length() / 2));
          text.setCaretPosition(middle);
          return text.requestFocusInWindow();
        });
    // The first analysis comes and colours the text.
    TimeUnit.SECONDS.sleep(4);
  }

  /**
   * How long each key took, ns.
   *
   * @param wall from the key to the end of its painting, which other processes lengthen
   * @param computing what the dispatch thread computed meanwhile
   */
  private record Times(List<Long> wall, List<Long> computing) {}

  /** What each of {@code count} keys took. */
  private Times type(int count) throws Exception {
    Times times = new Times(new ArrayList<>(), new ArrayList<>());
    key('\n');
    for (int i = 0; i < count; i++) {
      times.wall().add(key(TYPED.charAt(i % TYPED.length())));
      times.computing().add(queue.endCpuNs.get() - queue.begunCpuNs.get());
      // Quick hands, and now and then a pause in which the text is analysed.
      TimeUnit.MILLISECONDS.sleep(i % 12 == 11 ? 450 : 60);
    }
    return times;
  }

  /** Types a character, and waits until what it did is painted. */
  private long key(char c) throws InterruptedException {
    int code = c == '\n' ? KeyEvent.VK_ENTER : KeyEvent.getExtendedKeyCodeForChar(c);
    long now = System.currentTimeMillis();
    queue.begin();
    queue.postEvent(new KeyEvent(text, KeyEvent.KEY_PRESSED, now, 0, code, c));
    queue.postEvent(new KeyEvent(text, KeyEvent.KEY_TYPED, now, 0, KeyEvent.VK_UNDEFINED, c));
    queue.postEvent(new KeyEvent(text, KeyEvent.KEY_RELEASED, now, 0, code, c));
    return queue.awaitPainted();
  }

  private static <T> T onDispatchThread(java.util.concurrent.Callable<T> work)
      throws InterruptedException, InvocationTargetException, Exception {
    java.util.concurrent.FutureTask<T> task = new java.util.concurrent.FutureTask<>(work);
    EventQueue.invokeAndWait(task);
    return task.get();
  }

  private static void print(int lines, Times times, long longestNs) {
    System.out.printf(Locale.ROOT, "%n### A key typed in a program of %d lines, ms%n%n", lines);
    System.out.println("| what | p50 | p95 | p99 | longest |");
    System.out.println("| --- | ---: | ---: | ---: | ---: |");
    row("until it is painted", times.wall());
    row("computing of the dispatch thread", times.computing());
    System.out.printf(
        Locale.ROOT, "| longest event of any kind meanwhile | | | | %.2f |%n", ms(longestNs));
    System.err.println("slowest to compute: " + slowest(times.computing()));
  }

  /** Prints a row of a table: median, slowest twentieth and hundredth, and the slowest. */
  static void row(String what, List<Long> ns) {
    List<Long> sorted = ns.stream().sorted().toList();
    int count = sorted.size();
    System.out.printf(
        Locale.ROOT,
        "| %s | %.2f | %.2f | %.2f | %.2f |%n",
        what,
        ms(sorted.get(count / 2)),
        ms(sorted.get(count * 95 / 100)),
        ms(sorted.get(count * 99 / 100)),
        ms(sorted.getLast()));
  }

  /** The ten slowest with the characters that they typed. */
  private static List<String> slowest(List<Long> ns) {
    return IntStream.range(0, ns.size())
        .boxed()
        .sorted(Comparator.comparing((Integer i) -> ns.get(i)).reversed())
        .limit(10)
        .map(i -> String.format(Locale.ROOT, "%s at %d: %.1f ms", name(i), i, ms(ns.get(i))))
        .toList();
  }

  private static String name(int key) {
    char c = TYPED.charAt(key % TYPED.length());
    return c == '\n' ? "ENTER" : "'" + c + "'";
  }

  private static double ms(long ns) {
    return (double) ns / NS_PER_US / 1e3;
  }
}
