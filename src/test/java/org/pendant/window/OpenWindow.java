package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.pendant.command.ProductJvm;

/**
 * A desktop in a process of its own, worked with real mouse and key events. Components are named as
 * their {@code setName} says, keys as in {@link javax.swing.KeyStroke#getKeyStroke(String)}.
 */
final class OpenWindow implements AutoCloseable {
  /** Far longer than anything here takes, on a busy machine too. */
  private static final long PATIENCE_NS = TimeUnit.SECONDS.toNanos(60);

  private static final int LOOK_AGAIN_MS = 20;

  private final Process process;
  private final PrintStream requests;

  /** What the process has answered; nothing when it has ended. */
  private final BlockingQueue<Optional<String>> replies = new LinkedBlockingQueue<>();

  private OpenWindow(Process process) {
    this.process = process;
    requests = new PrintStream(process.getOutputStream(), true, StandardCharsets.UTF_8);
    Thread.ofPlatform().name("replies").daemon().start(this::listen);
  }

  /** A thread of its own: who reads from a process that hangs cannot be called off. */
  private void listen() {
    try (BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        replies.add(Optional.of(line));
      }
    } catch (IOException _) {
      // the pipe of a process that was killed
    }
    replies.add(Optional.empty());
  }

  /**
   * Opens one and waits until it is visible.
   *
   * @param folder for its settings and recovered texts
   * @param options for its JVM
   */
  static OpenWindow open(VirtualDisplay display, Path folder, String... options)
      throws IOException {
    return open(display, folder, List.of(), options);
  }

  /**
   * As {@link #open(VirtualDisplay, Path, String...)}.
   *
   * @param programs to open in it
   */
  static OpenWindow open(
      VirtualDisplay display, Path folder, List<Path> programs, String... options)
      throws IOException {
    List<String> all = new ArrayList<>(ProductJvm.WINDOW.options());
    all.addAll(List.of(options));
    return open(
        display,
        folder,
        programs,
        ProductJvm.WINDOW.classPath(),
        all,
        ProcessBuilder.Redirect.INHERIT);
  }

  /** Opens one whose JVM leaves an AOT cache when the window is closed. */
  static OpenWindow openAndTrain(VirtualDisplay display, Path folder) throws IOException {
    return open(
        display,
        folder,
        List.of(),
        ProductJvm.startableJars(),
        ProductJvm.WINDOW.trainingOptions(),
        // The JVM that writes the cache says there with which options, a page of them.
        ProcessBuilder.Redirect.to(folder.resolve("errors.txt").toFile()));
  }

  private static OpenWindow open(
      VirtualDisplay display,
      Path folder,
      List<Path> programs,
      String classPath,
      List<String> options,
      ProcessBuilder.Redirect errors)
      throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(
        List.of(
            "-ea",
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            // The JVM's own log goes to standard output otherwise, where the replies are.
            "-Xlog:disable",
            "-Xlog:all=error:stderr",
            "--sun-misc-unsafe-memory-access=allow"));
    command.addAll(options);
    command.addAll(List.of("-cp", classPath, Driver.class.getName()));
    programs.forEach(each -> command.add(each.toString()));
    ProcessBuilder builder = new ProcessBuilder(command).redirectError(errors);
    builder.environment().put("DISPLAY", display.name());
    builder.environment().put("XDG_CONFIG_HOME", folder.toString());
    builder.environment().put("XDG_STATE_HOME", folder.resolve("state").toString());
    welcomed(folder);
    OpenWindow window = new OpenWindow(builder.start());
    // The frame is shown before what is in it.
    window.awaitShown("header");
    return window;
  }

  /** What a user has who has closed the card of the very first start. */
  private static void welcomed(Path folder) throws IOException {
    Path settings = folder.resolve("pendant");
    if (!Files.exists(settings)) {
      Files.createDirectories(settings);
      Files.writeString(settings.resolve("settings.txt"), "help.welcomed = true\n");
    }
  }

  /** Presses and releases keys, such as {@code shift F5}. */
  void press(String keys) {
    act("press", keys);
  }

  /** Types text where the focus is. */
  void type(String text) {
    act("type", text);
  }

  /** Clicks when the component is visible and enabled. */
  void click(String name) {
    awaitEnabled(name);
    act("click", name);
  }

  /** Clicks the button that reads {@code text} inside a component. */
  void clickText(String name, String text) {
    awaitWords(name, text);
    act("click-text", name + "=" + text);
  }

  /** Clicks the cell of a table that reads {@code text}. */
  void clickCell(String name, String text) {
    awaitWords(name, text);
    act("click-cell", name + "=" + text);
  }

  /** Clicks the row of a list or tree that reads {@code text}, or the first that contains it. */
  void clickRow(String name, String text) {
    awaitWords(name, text);
    act("click-row", name + "=" + text);
  }

  /** Drags a row of a list or tree to just below a row of another, or of the same one. */
  void dragRow(String name, String text, String target, String below) {
    awaitWords(name, text);
    awaitWords(target, below);
    act("drag-row", name + "=" + text + " > " + target + "=" + below);
  }

  /** Unfolds a combo box by the mouse and clicks the item that reads {@code item}. */
  void pick(String box, String item) {
    click(box);
    clickRow("ComboBox.list", item);
    awaitHidden("ComboBox.list");
  }

  /** Presses the mouse button on a component and keeps it down until {@link #release}. */
  void hold(String name) {
    awaitEnabled(name);
    act("hold", name);
  }

  /** Lets the mouse button go. */
  void release() {
    act("release", "");
  }

  /** Opens a program by the dialog, and gives the focus back to the window. */
  void open(Path file) {
    takeFocus();
    press("control O");
    awaitFocus("open-dialog");
    type(file + "\n");
    awaitWords("program-name", String.valueOf(file.getFileName()));
    awaitHidden("open-dialog");
    takeFocus();
  }

  /** Without a window manager nobody else gives the window the focus, and keys are lost. */
  private void takeFocus() {
    click("rail-run");
    awaitFocus("pendant");
  }

  /** Drags the tab that reads {@code title} to the middle of a component. */
  void dragTab(String tabs, String title, String target) {
    await(title + " is a tab", () -> tabs(tabs).contains(title));
    awaitShown(target);
    act("drag", tabs + "=" + title + " > " + target);
  }

  /** Whether all of a component can be seen. */
  boolean whole(String name) {
    awaitShown(name);
    return Boolean.parseBoolean(ask("whole", name));
  }

  /** The titles of tabs, in their order. */
  List<String> tabs(String name) {
    awaitShown(name);
    return ask("tabs", name).lines().toList();
  }

  /** The names of what is visible that begin with {@code prefix}. */
  List<String> named(String prefix) {
    return ask("named", prefix).lines().toList();
  }

  /** What the menus have, a line for each entry: {@code File > Export > Save as script}. */
  List<String> menus() {
    return ask("menus", "pendant").lines().toList();
  }

  /** What keys can reach in the window and a screen reader has no name for; empty if nothing. */
  String nameless() {
    return ask("nameless", "pendant");
  }

  /** Chooses an item of a combo box, or a tab, by its text. */
  void choose(String name, String item) {
    awaitShown(name);
    act("choose", name + "=" + item);
  }

  /** Does an action of the palette by its title. */
  void perform(String title) {
    press("control shift P");
    awaitFocus("palette-query");
    type(title);
    await("first action is " + title, () -> words("palette-list").startsWith(title));
    press("ENTER");
    await("palette closed", () -> !shows("palette-query"));
  }

  /** Asks the window to close, as its frame's button does. */
  void askToClose() {
    askToClose("pendant");
  }

  /** Asks a window to close, that of a panel, say. */
  void askToClose(String name) {
    awaitShown(name);
    act("close", name);
  }

  /** Makes the window as large as {@code size}, such as {@code 1024x700}. */
  void resize(String size) {
    act("size", size);
  }

  /** Presses a button, or an item of the menu bar, by its name: in windows of any language. */
  void use(String name) {
    ask("use", name);
  }

  /** Presses one of the visible buttons whose names begin so, by its number, from 0. */
  void use(String prefix, int index) {
    ask("use-of", prefix + "=" + index);
  }

  /** The names of all items of the menu bar, which are their actions'. */
  List<String> items() {
    return ask("items", "").lines().toList();
  }

  /** How many rows, items or tabs there are to choose from. */
  int choices(String name) {
    awaitShown(name);
    return Integer.parseInt(ask("choices", name));
  }

  /** Chooses a row, an item or a tab by its number, from 0. */
  void select(String name, int index) {
    awaitShown(name);
    ask("select", name + "=" + index);
  }

  /** Texts for which there is too little room, a line each. */
  List<String> cutTexts() {
    return ask("cut", "").lines().toList();
  }

  /** Menus that are too large for a small window, a line each. */
  List<String> largeMenus() {
    return ask("large-menus", "").lines().toList();
  }

  /** How many texts were looked at for their room. */
  String lookedAtTexts() {
    return ask("texts", "");
  }

  /** Whether a component is visible. */
  boolean shows(String name) {
    return Boolean.parseBoolean(ask("shows", name));
  }

  /** Where a component is on the screen, such as {@code 640,120}. */
  String place(String name) {
    awaitShown(name);
    return ask("place", name);
  }

  /** Whether a switch or a check box is on. */
  boolean selected(String name) {
    awaitShown(name);
    return Boolean.parseBoolean(ask("selected", name));
  }

  /** Robot time in seconds. */
  double timeS() {
    return Double.parseDouble(words("robot-time").replace(" s", "").strip());
  }

  /** Waits until robot time has continued by so much. */
  void awaitTime(double durationS) {
    double startS = timeS();
    await(durationS + " s go by", () -> timeS() > startS + durationS);
  }

  /** What can be read on a visible component. */
  String words(String name) {
    awaitShown(name);
    return ask("words", name);
  }

  /** How many different colours the pixels of a component have. */
  long colours(String name) {
    awaitShown(name);
    return Long.parseLong(ask("colours", name));
  }

  /** How bright the pixels of a component are on average, 0 to 255. */
  long brightness(String name) {
    awaitShown(name);
    return Long.parseLong(ask("brightness", name));
  }

  /** Writes a picture of the display. */
  void picture(Path file) {
    ask("picture", file.toString());
  }

  /** Writes a picture of what can be seen of a component. */
  void picture(String name, Path file) {
    ask("picture-of", name + "=" + file);
  }

  /** What touched the window outside of the dispatch thread; empty if nothing did. */
  String complaints() {
    return ask("complaints", "");
  }

  /** Lets the window refresh itself several times, so that a picture of it is whole. */
  void settle() {
    AtomicInteger looks = new AtomicInteger();
    await("all is painted", () -> looks.incrementAndGet() > 25);
  }

  /** Waits until a component is visible. */
  void awaitShown(String name) {
    await(name + " is visible", () -> shows(name));
  }

  /** Waits until a component is not visible. */
  void awaitHidden(String name) {
    await(name + " is hidden", () -> !shows(name));
  }

  /** Waits until a component can be used. */
  void awaitEnabled(String name) {
    awaitShown(name);
    await(name + " is enabled", () -> enabled(name));
  }

  /** Whether a visible component can be used. */
  boolean enabled(String name) {
    return Boolean.parseBoolean(ask("enabled", name));
  }

  /** Waits until keys go to a component or to something in it. */
  void awaitFocus(String name) {
    awaitShown(name);
    await(name + " has the focus", () -> focused(name));
  }

  private boolean focused(String name) {
    return Boolean.parseBoolean(ask("focused", name));
  }

  /** Presses Tab until keys go to a component. */
  void tabTo(String name) {
    awaitShown(name);
    await(
        "Tab leads to " + name,
        () -> {
          boolean there = focused(name);
          if (!there) {
            press("TAB");
          }
          return there || focused(name);
        });
  }

  /** Chooses in a combo box by the arrow down, going there by Tab. */
  void arrowTo(String box, String item) {
    tabTo(box);
    await(
        "the arrow leads to " + item,
        () -> {
          boolean there = words(box).equals(item);
          if (!there) {
            press("DOWN");
          }
          return there;
        });
    press("ENTER");
    awaitHidden("ComboBox.list");
    assertEquals(item, words(box));
  }

  /** Replaces what is in a field, going there by Tab. */
  void typeInto(String field, String text) {
    tabTo(field);
    press("control A");
    type(text);
    awaitWords(field, text);
  }

  /** Gives the window the keys, as a window manager does when a dialog has gone. */
  void raise() {
    act("raise", "");
    awaitFocus("pendant");
  }

  /** Waits until a component reads {@code part} somewhere. */
  void awaitWords(String name, String part) {
    awaitShown(name);
    await(name + " reads " + part, () -> words(name).contains(part));
  }

  /** Waits until a condition holds; fails when it does not for long. */
  void await(String what, BooleanSupplier condition) {
    long deadlineNs = System.nanoTime() + PATIENCE_NS;
    while (!condition.getAsBoolean()) {
      if (ended()) {
        fail("the window is gone, waiting until " + what);
      }
      if (System.nanoTime() > deadlineNs) {
        fail("waited in vain until " + what + "; the window reads: " + summary());
      }
    }
  }

  private String summary() {
    String words = ask("words", "pendant").replace('\n', ' ');
    return words.substring(0, Math.min(words.length(), 1_000));
  }

  /** Waits a moment for the process, so that questions do not crowd its dispatch thread. */
  private boolean ended() {
    try {
      return process.waitFor(LOOK_AGAIN_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return fail("interrupted", e);
    }
  }

  /** Does something. What closes the window may end its process before that has answered. */
  private void act(String verb, String what) {
    request(verb, what);
  }

  private String ask(String verb, String what) {
    return request(verb, what)
        .orElseGet(() -> fail("the window's process ended at " + verb + " " + what));
  }

  /** The answer, or nothing from a process that has ended. */
  private Optional<String> request(String verb, String what) {
    requests.println(verb + "\t" + what.replace("\\", "\\\\").replace("\n", "\\n"));
    // One that closes its window may end in the middle of its answer.
    Optional<String> reply = nextReply(verb + " " + what).filter(line -> line.indexOf('\t') >= 0);
    if (reply.isEmpty()) {
      replies.add(reply);
      return reply;
    }
    String[] words = reply.orElseThrow().split("\t", 2);
    return words[0].equals("ok")
        ? Optional.of(words[1].translateEscapes())
        : fail(verb + " " + what + ": " + words[1]);
  }

  /** A window that does not answer is killed, or its process would outlive the tests. */
  private Optional<String> nextReply(String request) {
    try {
      Optional<String> reply = replies.poll(PATIENCE_NS, TimeUnit.NANOSECONDS);
      if (reply != null) {
        return reply;
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    String threads = threads();
    kill();
    return fail("the window does not answer to " + request + "; its threads:\n" + threads);
  }

  /** The stacks of the window's threads, and the locks they hold, unless it hangs altogether. */
  private String threads() {
    try {
      Path stacks = Files.createTempFile("threads", ".txt");
      Process jcmd =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "jcmd").toString(),
                  Long.toString(process.pid()),
                  "Thread.print",
                  "-l")
              .redirectErrorStream(true)
              .redirectOutput(stacks.toFile())
              .start();
      if (!jcmd.waitFor(10, TimeUnit.SECONDS)) {
        jcmd.destroyForcibly();
      }
      String text = Files.readString(stacks);
      Files.delete(stacks);
      return text;
    } catch (IOException e) {
      return e.getMessage();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "interrupted";
    }
  }

  /** Waits until the desktop has been closed and its process has ended. */
  void awaitEnd() {
    long deadlineNs = System.nanoTime() + PATIENCE_NS;
    while (!ended()) {
      if (System.nanoTime() > deadlineNs) {
        fail("the window has not ended");
      }
    }
    assertEquals(0, process.exitValue());
  }

  /** Ends the process as a crash does. */
  void kill() {
    process.destroyForcibly();
    process.onExit().join();
  }

  @Override
  public void close() {
    kill();
  }
}
