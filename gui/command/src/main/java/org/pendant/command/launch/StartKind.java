package org.pendant.command.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;

/**
 * Kind of start: what a command line starts, and which options of the JVM that is worth.
 * docs/benchmarks.md has the measurements behind them. The shell reads them from the table that
 * {@link StartTable} writes, and the launchers of jpackage have those of one kind each.
 */
public enum StartKind {
  /** A command that ends soon, as most do. */
  COMMAND("pendant", List.of(), List.of()),

  /**
   * An editor stays for hours: its server is worth the optimizing compiler. What an edit leaves
   * behind is dropped in a young generation that holds it, so that memory stays small whatever the
   * machine has.
   */
  LANGUAGE_SERVER(
      "editors",
      List.of(Options.OPTIMIZING),
      List.of(
          "-Xms80m",
          "-Xmn48m",
          "-XX:SurvivorRatio=4",
          "-XX:MinHeapFreeRatio=20",
          "-XX:MaxHeapFreeRatio=40")),

  /** The debug adapter of an editor. */
  DEBUG_ADAPTER("editors", List.of(), List.of()),

  /**
   * Runs for minutes on end: the optimizing compiler pays. What a frame leaves behind dies in a
   * young generation that holds some.
   */
  SWEEP("sweep", List.of(Options.OPTIMIZING), List.of("-Xmn64m")),

  /** A sweep whose runs are elsewhere. */
  SWEEP_BY_ENGINE("pendant", List.of(Options.OPTIMIZING), List.of("-Xmn64m")),

  /**
   * A window is open all day. It has its heap collected itself when enough may have died
   * (HeapCare); the JVM has what is free given back then, down to where it began. There is no
   * limit: what people open may be as large as it is. What malloc has free, compiling and drawing
   * need much of it for a moment, is given back once a minute. The heap is collected as a whole
   * when 15 % of what is reserved for code have been used: of 48 MB before the first picture.
   *
   * <p>Before Java takes the fonts that the window brings it reads all that it knows to be
   * installed, to find one of the same name; with an empty path to them it knows of none. Those for
   * characters that ours do not have come from fontconfig.
   */
  WINDOW(
      "window",
      List.of(Options.TRIM_MALLOC, "-XX:ReservedCodeCacheSize=128m", Options.NO_FONT_PATH),
      List.of(
          "-Xms64m",
          "-Xmn24m",
          "-XX:MinHeapFreeRatio=10",
          "-XX:MaxHeapFreeRatio=20",
          "-XX:-ShrinkHeapInSteps",
          "-XX:MetaspaceSize=64m"));

  /** Options that several have; here because those above may not refer to fields of the enum. */
  static final class Options {
    /** Behind the common ones: the optimizing compiler as well. */
    static final String OPTIMIZING = "-XX:TieredStopAtLevel=4";

    static final String TRIM_MALLOC = "-XX:TrimNativeHeapInterval=60000";
    static final String NO_FONT_PATH = "-Dsun.java2d.fontpath=";

    /** Elsewhere malloc cannot be trimmed, which the JVM says, and there is no fontconfig. */
    static final List<String> LINUX_ONLY = List.of(TRIM_MALLOC, NO_FONT_PATH);

    private Options() {}
  }

  /**
   * Options of every start, the same for training the AOT cache and for using it, which is refused
   * otherwise. A cache keeps which methods were compiled how well, too: what runs with the
   * optimizing compiler has one that was trained with it, or nearly all stays with the first. The
   * JVM's own log goes to stderr: stdout belongs to the script that runs. The 3D view's library
   * uses sun.misc.Unsafe, which the JVM would complain about.
   */
  static final List<String> COMMON =
      List.of(
          "-XX:+UseSerialGC",
          "-XX:TieredStopAtLevel=1",
          "-Xlog:disable",
          "-Xlog:all=error:stderr",
          "--sun-misc-unsafe-memory-access=allow");

  private final String cache;
  private final List<String> options;
  private final List<String> heap;

  StartKind(String cache, List<String> options, List<String> heap) {
    this.cache = cache;
    this.options = options;
    this.heap = heap;
  }

  /** The name of the AOT cache that it starts with. */
  public String cache() {
    return cache;
  }

  /** Its options behind {@link #COMMON}. */
  List<String> options() {
    return options;
  }

  /** More of them, unless the user gives the heap a size, which these may not fit. */
  List<String> heap() {
    return heap;
  }

  /** Its name in files: {@code language-server}. */
  String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /**
   * The kind of a command line, as far as that can be told without reading all of it.
   *
   * @param words behind {@code pendant}
   * @param display whether windows can be shown
   * @param isFile whether a word names a file
   */
  public static StartKind of(List<String> words, boolean display, Predicate<String> isFile) {
    return switch (words.isEmpty() ? "" : words.getFirst()) {
      case "lsp" -> LANGUAGE_SERVER;
      case "dap" -> DEBUG_ADAPTER;
      case "sweep" ->
          words.stream().skip(1).anyMatch(each -> each.startsWith("--engine"))
              ? SWEEP_BY_ENGINE
              : SWEEP;
      default -> display && opensWindow(words, isFile) ? WINDOW : COMMAND;
    };
  }

  private static boolean opensWindow(List<String> words, Predicate<String> isFile) {
    if (words.contains("--help") || words.contains("-h")) {
      return false;
    }
    String first = words.isEmpty() ? "open" : words.getFirst();
    return !first.equals("--version")
        && (first.isEmpty() || first.equals("open") || first.startsWith("-") || isFile.test(first));
  }

  /**
   * All options of a start of this kind.
   *
   * @param given what the user gives the JVM, which comes last and wins
   * @param system the name of the operating system, as Java calls it
   */
  public List<String> all(List<String> given, String system) {
    List<String> all = new ArrayList<>(COMMON);
    options.stream()
        .filter(each -> system.equals("Linux") || !Options.LINUX_ONLY.contains(each))
        .forEach(all::add);
    if (given.stream().noneMatch(StartKind::isAboutTheHeap)) {
      all.addAll(heap);
    }
    all.addAll(given);
    return all;
  }

  private static boolean isAboutTheHeap(String option) {
    return option.startsWith("-Xm")
        || option.contains("HeapSize=")
        || option.contains("NewSize=")
        || option.contains("MaxRAM");
  }
}
