package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;
import org.pendant.project.program.script.GeneratedNames;

/** What the panel of variables shows while no debugger holds the program. */
final class LiveVariablesTest {
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final Map<String, String> remembered = new HashMap<>();
  private final Favourites favourites = new Favourites(settings());
  private final HiddenNames hidden = new HiddenNames(settings());
  private final ValueTree tree =
      new ValueTree(
          new SessionLink(this::submit, Runnable::run), (reader, scope) -> List.of(), () -> {});
  private long nowMs = 1000;
  private final VariablesPresenter variables =
      new VariablesPresenter(tree, favourites, hidden, () -> nowMs);

  private Settings settings() {
    return new MemorySettings(remembered);
  }

  private CompletableFuture<Reply> submit(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    controller.advance();
    return reply;
  }

  private void start(String... lines) {
    var _ =
        submit(
            new ProgramCommand.StartProgram(
                TestController.program(controller, String.join("\n", lines) + "\n")));
    variables.refresh(controller.state(), false);
  }

  /** Lets robot time and the clock of the screen continue, and looks. */
  private void pass(int frames, long ms) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
    }
    nowMs += ms;
    variables.refresh(controller.state(), false);
  }

  private List<String> rows() {
    return DebugFixture.rows(tree);
  }

  private ValueRow.Value row(String name) {
    return DebugFixture.row(tree, name);
  }

  private void countForEver() {
    start(
        "def counting():",
        "  still = 7",
        "  i = 0",
        "  list = [1, 2, 3]",
        "  while True:",
        "    i = i + 1",
        "    list[1] = i",
        "    sync()",
        "  end",
        "end");
  }

  @Test
  void variablesAreThereWhileTheProgramRuns() {
    assertTrue(variables.note().startsWith("No program has run yet."), variables.note());
    countForEver();
    assertEquals(List.of("Global", "still = 7", "i = 1", "list = [1, 1, 3]"), rows());
    pass(20, 100);
    assertEquals(List.of("Global", "still = 7", "i = 21 *", "list = [1, 21, 3] *"), rows());
    assertEquals("", variables.note());
  }

  @Test
  void thoseThatNodesMakeAreHiddenUntilPeopleWantThem() {
    hidden.start(new GeneratedNames("stack", Set.of("At_p", "At_q")));
    start("def stack():", "  At_p = 1", "  At_q = 2", "  placed = 3", "  sleep(9)", "end");
    assertEquals(List.of("Global", "placed = 3"), rows());
    assertEquals("2 that nodes make are hidden", variables.omission());
    favourites.toggle("stack", "At_q");
    assertEquals(List.of("Global", "At_q = 2", "placed = 3"), rows());
    assertEquals("1 that nodes make are hidden", variables.omission());
    variables.filter("at_p");
    assertEquals(List.of("Global", "At_p = 1"), rows());
    variables.filter("");
    hidden.toggle();
    pass(1, 0);
    assertEquals(List.of("Global", "At_q = 2", "At_p = 1", "placed = 3"), rows());
    assertEquals("", variables.omission());
    hidden.toggle();
    assertEquals(List.of("Global", "At_q = 2", "placed = 3"), rows());
  }

  @Test
  void thoseThatNodesMakeStayHiddenWhenAnotherProgramStarts() {
    hidden.start(new GeneratedNames("stack", Set.of("At_p")));
    hidden.start(new GeneratedNames("sort", Set.of("Bin_p")));
    hidden.start(GeneratedNames.NONE);

    assertTrue(hidden.hides("stack", "At_p"));
    assertTrue(hidden.hides("sort", "Bin_p"));
    assertFalse(hidden.hides("sort", "At_p"));
    hidden.start(new GeneratedNames("stack", Set.of("Feeder_p")));
    assertFalse(hidden.hides("stack", "At_p"));
    assertTrue(hidden.hides("stack", "Feeder_p"));
  }

  @Test
  void theTableIsNotChangedMoreThanTenTimesASecond() {
    countForEver();
    List<ValueRow> before = tree.rows();
    pass(20, 50);
    assertEquals(before, tree.rows());
    pass(20, 50);
    assertEquals("41", row("i").text());
  }

  @Test
  void aChangeIsMarkedForAMoment() {
    start("def program():", "  a = 1", "  b = 1", "  sleep(0.1)", "  a = 2", "  sleep(9)", "end");
    pass(60, 200);
    assertEquals(List.of("Global", "a = 2 *", "b = 1"), rows());
    assertEquals(ValueRow.Change.JUST_NOW, row("a").change());
    pass(20, ValueChanges.IN_SIGHT_MS - 100);
    assertTrue(row("a").changed());
    pass(20, 200);
    assertFalse(row("a").changed());
  }

  @Test
  void whatIsUnfoldedStaysSoAndGoesOn() {
    countForEver();
    tree.toggle(row("list"));
    assertEquals(
        List.of(
            "Global", "still = 7", "i = 1", "list = [1, 1, 3]", " [0] = 1", " [1] = 1", " [2] = 3"),
        rows());
    pass(20, 100);
    assertEquals("21", row("[1]").text());
    tree.toggle(row("list"));
    assertEquals(4, rows().size());
  }

  @Test
  void aLongListTellsThatTheRestIsSeenWhenTheProgramIsHeld() {
    start("def program():", "  l = make_list(3000, 5, 3000)", "  sleep(9)", "end");
    tree.toggle(row("l"));
    assertEquals("100 of 3000 shown \u2013 Enter shows more", DebugFixture.rows(tree).getLast());
    for (int page = 0; page < 10; page++) {
      tree.showMore((ValueRow.More) tree.rows().getLast());
    }
    assertTrue(
        rows().getLast().endsWith("of 3000 shown \u2013 pause in the debugger to see all"),
        rows().getLast());
  }

  @Test
  void aGlobalVariableChangesWhileTheProgramRuns() {
    start("def program():", "  a = 1", "  sleep(0.2)", "  b = a", "  sleep(9)", "end");
    assertTrue(tree.canAssign(row("a")));
    tree.assign(row("a"), "20 + 1");
    pass(200, 200);
    assertEquals("21", row("b").text());
    tree.assign(row("a"), "\"text\"");
    assertTrue(rows().get(2).startsWith("! Not changed: "), rows().toString());
  }

  @Test
  void aLocalVariableOnlyChangesWhileItsCallIsHeld() {
    start("x = 1", "def main():", "  local here = 2", "  sleep(9)", "end", "main()");
    assertEquals(List.of("Local in main", "here = 2", "Global", "x = 1"), rows());
    assertFalse(tree.canAssign(row("here")));
    assertEquals("Pause in the debugger to change it", tree.whyFixed(row("here")));
    assertTrue(tree.canAssign(row("x")));
  }

  @Test
  void theLastValuesStayWhenTheProgramHasEnded() {
    start("def weld():", "  a = 1", "end");
    pass(5, 200);
    assertEquals(List.of("Global, last values of weld", "a = 1"), rows());
    assertFalse(tree.canAssign(row("a")));
  }

  @Test
  void favouritesComeFirstAndBelongToTheirProgram() {
    countForEver();
    variables.toggleFavourite(row("list"));
    variables.toggleFavourite(row("i"));
    assertEquals(List.of("Global", "i = 1", "list = [1, 1, 3]", "still = 7"), rows());
    assertTrue(row("i").favourite());
    var _ = submit(new ProgramCommand.StopProgram());
    start("def another():", "  still = 7", "  i = 0", "  sleep(9)", "end");
    assertEquals(List.of("Global", "still = 7", "i = 0"), rows());
    assertEquals("list\ni", remembered.get("variables.favourites.counting"));
    assertTrue(new Favourites(settings()).of("counting").contains("i"));
  }

  @Test
  void theFilterLooksAtNames() {
    countForEver();
    variables.filter("S");
    assertEquals(List.of("Global", "still = 7", "list = [1, 1, 3]"), rows());
    variables.filter("nothing");
    assertEquals("No variable has 'nothing' in its name.", variables.note());
    variables.filter("");
    assertEquals(4, rows().size());
  }

  @Test
  void aProgramWithoutVariablesSaysSo() {
    start("def program():", "  sleep(1)", "end");
    assertEquals("The program program has no variables.", variables.note());
  }

  @Test
  void valuesOfAnotherRunAreNoChanges() {
    start("def program():", "  a = 1", "  sleep(9)", "end");
    var _ = submit(new ProgramCommand.StopProgram());
    start("def program():", "  a = 2", "  sleep(9)", "end");
    assertEquals(List.of("Global", "a = 2"), rows());
  }

  @Test
  void watchedVariablesAreFollowedAndOtherExpressionsWait() {
    countForEver();
    List<ValueNode.Group> groups =
        Watches.live(List.of("list[1]", "i + 1", "none"), controller.state().variables(), Map.of());
    assertEquals(
        List.of("list[1] = 1", "i + 1 = ", "none = "),
        groups.getFirst().nodes().stream()
            .map(node -> node.variable().name() + " = " + node.variable().text())
            .toList());
  }

  @Test
  void namesOfProgramsWithOddCharactersKeepTheirFavouritesApart() {
    favourites.toggle("a b", "x");
    favourites.toggle("a_b", "y");
    assertEquals(List.of("x"), List.copyOf(favourites.of("a b")));
    assertEquals(List.of("y"), List.copyOf(favourites.of("a_b")));
    assertTrue(
        remembered.keySet().stream().allMatch(name -> name.matches("[\\w.:-]+")),
        remembered.toString());
  }
}
