package org.pendant.window;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import org.pendant.text.Language;

/**
 * Text tour: goes through what a small window shows, in one language, and gathers the texts that
 * have too little room. What it uses it names by what is the same in every language.
 */
final class TextTour {
  /** Looks that find something before it counts: rows that wrap ask for their height later. */
  private static final int SURE = 10;

  private final OpenWindow window;
  private final Path folder;

  /** What is cut, with the place where it was met first, by what does not change with numbers. */
  private final Map<String, String> cut = new LinkedHashMap<>();

  /** Names of the cards that were seen. */
  private final Set<String> cards = new TreeSet<>();

  private TextTour(OpenWindow window, Path folder) {
    this.window = window;
    this.folder = folder;
  }

  /**
   * What there is to know after a tour.
   *
   * @param names of what the menus have, and of the cards that were seen
   */
  record Report(List<String> cut, String lookedAt, List<String> names) {}

  /** What is gone through. */
  enum Part {
    /** Screens, panels and pages of the installation. */
    SCREENS(TextTour::everyScreen),
    /** Forms of all kinds of nodes. */
    NODES(TextTour::nodes),
    /** Forms of all kinds of devices, objects, and the wires. */
    CELL(TextTour::cell),
    /** Windows and panels that ask for something or help. */
    DIALOGS(TextTour::dialogs),
    /** What the editor asks and tells. */
    EDITOR(tour -> tour.work().editor()),
    /** Programs that are paused, ask and stop. */
    RUNS(tour -> tour.work().runs()),
    /** Sweeps of parameters, planned and run. */
    SWEEPS(tour -> tour.work().sweeps()),
    /** Tests that pass and fail. */
    TESTS(tour -> tour.work().tests()),
    /** Clients that are connected. */
    CLIENTS(tour -> tour.work().clients()),
    /** Values that cannot be. */
    WRONG_VALUES(tour -> tour.work().wrongValues()),
    /** Questions before something is lost. */
    QUESTIONS(tour -> tour.work().questions());

    private final Steps steps;

    Part(Steps steps) {
      this.steps = steps;
    }
  }

  private interface Steps {
    void of(TextTour tour) throws IOException;
  }

  /**
   * Opens a window and goes through it.
   *
   * @param folder for its settings
   */
  static Report of(Language language, VirtualDisplay display, Path folder, Part part)
      throws IOException {
    FormSheet.prepare(folder);
    try (OpenWindow window =
        OpenWindow.open(display, folder, "-Duser.language=" + language.code())) {
      window.resize("1024x700");
      // before files with long names are opened, which the menus list
      List<String> lines = new ArrayList<>(window.largeMenus());
      TextTour tour = new TextTour(window, folder);
      part.steps.of(tour);
      lines.addAll(tour.cut.values());
      List<String> names = new ArrayList<>(window.items());
      names.addAll(tour.cards);
      return new Report(lines, window.lookedAtTexts(), names);
    }
  }

  private WorkTour work() {
    return new WorkTour(this, window, folder);
  }

  private void everyScreen() {
    screens();
    panels();
    each("installation-pages", "rail-installation");
  }

  private void nodes() {
    each("program-tree", "rail-program");
    each("program-tabs", "rail-program");
  }

  /** Every screen of the rail. */
  void screens() {
    for (String each : window.named("rail-")) {
      show(each);
    }
  }

  /** Every panel of the View menu. */
  void panels() {
    for (String each : window.items()) {
      if (each.startsWith("menu-view-")) {
        show(each);
      }
    }
  }

  private void cell() {
    window.use("menu-example-cell-tend-machine");
    window.use("menu-view-cell");
    window.awaitShown("cell-device-add");
    window.use("cell-device-add");
    int kinds = window.named("cell-device-add-").size();
    for (int i = 0; i < kinds; i++) {
      window.use("cell-device-add-", i);
    }
    window.press("ESCAPE");
    each("cell-device-list", "menu-view-cell");
    each("cell-object-list", "menu-view-cell");
    each("cell-pages", "menu-view-cell");
  }

  private void dialogs() {
    for (String each :
        List.of(
            "file-open",
            "file-save-as",
            "file-open-recording",
            "installation-open",
            "scene-file-open",
            "scene-file-save-as",
            "waveforms-open",
            "sweep-open",
            "log-export")) {
      window.use("menu-" + each);
      String dialog = each.contains("open") ? "open-dialog" : "save-dialog";
      window.awaitFocus(dialog);
      look(each);
      window.press("ESCAPE");
      window.awaitHidden(dialog);
    }
    for (String each :
        List.of("documentation", "shortcuts", "about", "palette", "keys", "welcome")) {
      show("menu-help-" + each);
    }
  }

  /** Uses something and looks at what has come of it. */
  void show(String name) {
    window.use(name);
    look(name);
  }

  /** Every row, item or tab of something, after a way to it. */
  void each(String name, String way) {
    window.use(way);
    for (int i = 0; i < window.choices(name); i++) {
      window.select(name, i);
      look(name + " " + i);
    }
  }

  /** Looks several times, and takes what every look finds: numbers change all the time. */
  void look(String where) {
    Map<String, String> found = new LinkedHashMap<>(found());
    AtomicInteger looks = new AtomicInteger();
    window.await(
        "the window is laid out",
        () -> {
          found.keySet().retainAll(found().keySet());
          return found.isEmpty() || looks.incrementAndGet() >= SURE;
        });
    found.forEach((each, text) -> cut.putIfAbsent(each, where + ": " + text));
    cards.addAll(window.named("card-"));
  }

  /** What one look finds, by what does not change with numbers. */
  private Map<String, String> found() {
    Map<String, String> found = new LinkedHashMap<>();
    window.cutTexts().forEach(each -> found.put(each.replaceAll("[0-9.]+", "0"), each));
    return found;
  }
}
