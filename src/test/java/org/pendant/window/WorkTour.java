package org.pendant.window;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.pendant.client.Served;

/**
 * Work tour: what a window shows around programs and files of people, for a {@link TextTour}. What
 * the editor asks, runs, tests, sweeps, connected clients, wrong values, and questions.
 */
final class WorkTour {
  private static final int PRIMARY = 30_001;
  private static final int DASHBOARD = 29_999;
  private static final int ADDRESS = 221;
  private static final int OFFSET = 2_000;

  private final TextTour tour;
  private final OpenWindow window;
  private final Path folder;
  private int programs;

  WorkTour(TextTour tour, OpenWindow window, Path folder) {
    this.tour = tour;
    this.window = window;
    this.folder = folder;
  }

  /** What the editor asks and tells. */
  void editor() throws IOException {
    program("def part():", "  LONG = 0.5", "  unused = 1", "  sleep(LNG)", "end");
    for (String each :
        List.of(
            "find",
            "replace",
            "line",
            "symbol",
            "open-file",
            "find-in-files",
            "rename",
            "complete")) {
      toScript(0);
      for (int i = 0; i < "def p".length(); i++) {
        window.press("RIGHT");
      }
      tour.show("menu-editor-" + each);
      window.press("ESCAPE");
    }
    tour.show("menu-view-problems");
    toScript(1);
    for (String each : List.of("debug-conditional-breakpoint", "debug-logpoint")) {
      window.use("menu-" + each);
      window.awaitShown("breakpoint-condition");
      tour.look(each);
    }
    tour.show("menu-debug-remove-breakpoints");
  }

  /** Programs that are paused, looked back at, ask and stop. */
  void runs() throws IOException {
    program(
        "def twice(n):",
        "  return 2 * n",
        "end",
        "a = 1",
        "sleep(0.1)",
        "a = twice(a)",
        "sleep(0.5)");
    toScript(1);
    window.press("F9");
    window.press("F5");
    window.awaitShown("debug-bar-step");
    tour.screens();
    tour.panels();
    tour.show("menu-view-call-stack");
    window.click("rail-script");
    window.click("debug-bar-step-back");
    window.awaitShown("past-banner");
    tour.screens();
    window.use("menu-timeline-live");
    window.awaitHidden("past-banner");
    stop();
    tour.look("stopped");
    start("popup(\"Put the next tray into the cell.\", \"Tray is full\", blocking=True)");
    window.awaitShown("popup-text");
    tour.look("popup");
    stop();
    start("n = request_integer_from_primary_client(\"How many parts are on the tray?\")");
    window.awaitFocus("popup-field");
    window.type("3.5\n");
    window.awaitShown("popup-error");
    tour.look("question");
    stop();
    start("protective_stop()", "sleep(1)");
    window.awaitShown("stop-card");
    tour.screens();
    stop();
    window.await(
        "the arm is ready",
        () -> {
          window.press("F4");
          return !window.shows("stop-card");
        });
  }

  /** A sweep that is planned, wrong and run. */
  void sweeps() throws IOException {
    program("def nap():", "  LONG = 0.5", "  sleep(LONG)", "end");
    window.use("menu-view-sweep");
    tour.show("menu-sweep-new");
    window.awaitWords("sweep-parameters", "LONG");
    window.awaitShown("sweep-wrong");
    tour.look("nothing varied");
    window.clickCell("sweep-parameters", "LONG");
    window.press("SPACE");
    for (int i = window.choices("sweep-method") - 1; i >= 0; i--) {
      window.select("sweep-method", i);
      tour.look("sweep-method " + i);
    }
    window.awaitEnabled("sweep-start");
    window.use("sweep-start");
    window.awaitShown("sweep-progress");
    window.await("5 runs are done", () -> digits("sweep-progress").startsWith("55"));
    tour.look("sweep");
    window.clickCell("sweep-rows", "0.75");
    tour.look("sweep run");
  }

  /** Tests that pass and fail. */
  void tests() throws IOException {
    Files.write(
        folder.resolve("station_test.script"),
        List.of(
            "def test_the_station_is_quick():",
            "  start(\"station_1.script\")",
            "  wait_for_end(within=0.1)",
            "end",
            "def test_numbers_of_parts_are_equal():",
            "  assert_equal(1, 2)",
            "end",
            "def test_it_ends():",
            "  start(\"station_1.script\")",
            "  wait_for_end()",
            "end"));
    program("sleep(0.5)");
    window.use("menu-view-tests");
    window.awaitShown("tests-tree");
    tour.look("tests");
    window.use("tests-coverage");
    window.use("tests-run-all");
    window.await("all have run", () -> digits("tests-tree").contains("13"));
    tour.each("tests-tree", "menu-view-tests");
  }

  /** Who is connected, and what was said. */
  void clients() throws IOException {
    program("sleep(1)");
    window.use("menu-view-ports");
    fill("ports-host", "256");
    tour.look("wrong address");
    InetAddress address = InetAddress.getByName(Served.host(ADDRESS));
    fill("ports-host", address.getHostAddress());
    fill("ports-offset", String.valueOf(OFFSET));
    window.click("ports-open");
    window.await(
        "the ports are open", () -> window.words("ports-table").contains("" + (PRIMARY + OFFSET)));
    tour.look("open ports");
    window.use("menu-view-clients");
    tour.look("nobody");
    try (Socket primary = new Socket(address, PRIMARY + OFFSET);
        Socket dashboard = new Socket(address, DASHBOARD + OFFSET)) {
      say(primary, "def visitor():\n  sync()\nend\n");
      say(dashboard, "programState\nload none.urp\n");
      window.awaitWords("clients-messages", "load none.urp");
      tour.look("clients");
      tour.each("clients-messages", "menu-view-clients");
      tour.each("clients-table", "menu-view-clients");
    }
    window.use("menu-view-ports");
    window.click("ports-open");
  }

  private static void say(Socket socket, String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** Values in the installation that cannot be, and the question before the safe ones change. */
  void wrongValues() {
    window.use("menu-installation-page-limits");
    window.use("limits-unlock");
    window.awaitShown("limits-apply");
    fill("limits-normal-power", "much");
    window.press("TAB");
    window.awaitShown("limits-grid-problem");
    tour.look("limits");
    fill("limits-normal-power", "150");
    window.press("TAB");
    window.awaitHidden("limits-grid-problem");
    window.use("limits-apply");
    window.awaitShown("limits-apply-back");
    tour.look("safety question");
    window.use("limits-apply-back");
    window.use("limits-discard");
  }

  /** Questions before something is lost. */
  void questions() throws IOException {
    start("while True:", "  sync()", "end");
    window.awaitEnabled("program-stop");
    window.use("menu-robot-restart");
    answerHarmless("robot-change-");
    stop();
    toScript(0);
    window.type("# mine\n");
    window.awaitWords("script-text", "mine");
    window.askToClose();
    answerHarmless("unsaved-");
  }

  /** Looks at a question in the window, and gives the last answer, which changes nothing. */
  private void answerHarmless(String prefix) {
    window.await("a question", () -> window.named(prefix).size() > 1);
    tour.look(prefix);
    window.use(prefix, window.named(prefix).size() - 1);
    window.await("no question", () -> window.named(prefix).isEmpty());
  }

  /** Puts the caret into the script, below so many lines. */
  private void toScript(int lines) {
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    for (int i = 0; i < lines; i++) {
      window.press("DOWN");
    }
  }

  private void fill(String field, String text) {
    window.click(field);
    window.awaitFocus(field);
    window.press("control A");
    window.type(text);
  }

  private String digits(String name) {
    return window.words(name).replaceAll("[^0-9]", "");
  }

  /** Opens a program of these lines; each has a file of its own. */
  private void program(String... lines) throws IOException {
    programs++;
    Path file = folder.resolve("station_" + programs + ".script");
    Files.write(file, List.of(lines));
    window.open(file);
  }

  private void start(String... lines) throws IOException {
    program(lines);
    window.press("F5");
  }

  private void stop() {
    window.click("rail-run");
    window.awaitFocus("pendant");
    window.press("shift F5");
    window.await("nothing runs", () -> !window.enabled("program-stop"));
  }
}
