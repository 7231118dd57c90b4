package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

final class ValueTreeTest {
  private final DebugFixture fixture =
      new DebugFixture(
          "def program():",
          "  global n = 1",
          "  global part = struct(name=\"bolt\", sizes=[4, 5])",
          "  global many = make_list(250, 0)",
          "  n = 2",
          "  part.sizes[1] = 6",
          "  sync()",
          "end");
  private final DebugPresenter debug = fixture.debug();
  private final ValueTree tree = debug.variables();

  private void holdAt(Integer... lines) {
    fixture.breakAt(lines);
    fixture.run();
  }

  private void toggle(String name) {
    tree.toggle(DebugFixture.row(tree, name));
  }

  @Test
  void partsAreReadWhenTheyAreUnfolded() {
    holdAt(5);
    assertEquals(4, tree.rows().size());
    toggle("part");
    toggle("sizes");
    assertEquals(
        List.of(
            "part = {name = \"bolt\", sizes = [4, 5]}",
            " name = \"bolt\"",
            " sizes = [4, 5]",
            "  [0] = 4",
            "  [1] = 5"),
        DebugFixture.rows(tree).subList(2, 7));
    toggle("part");
    assertEquals(4, tree.rows().size());
  }

  @Test
  void longListsComeInPages() {
    holdAt(5);
    toggle("many");
    assertEquals(4 + 100 + 1, tree.rows().size());
    ValueRow.More more = (ValueRow.More) tree.rows().getLast();
    assertEquals("100 of 250 shown \u2013 Enter shows more", more.text());
    tree.showMore(more);
    tree.showMore((ValueRow.More) tree.rows().getLast());
    assertEquals(4 + 250, tree.rows().size());
  }

  @Test
  void whatHasChangedSinceTheLastStopIsMarked() {
    holdAt(5);
    toggle("part");
    debug.steps().over();
    fixture.advance();
    assertTrue(DebugFixture.rows(tree).contains("n = 2 *"), DebugFixture.rows(tree).toString());
    debug.steps().over();
    fixture.advance();
    assertTrue(DebugFixture.rows(tree).contains("n = 2"), DebugFixture.rows(tree).toString());
    assertTrue(
        DebugFixture.rows(tree).contains(" sizes = [4, 6] *"), DebugFixture.rows(tree).toString());
  }

  @Test
  void aValueIsChangedByAnExpression() {
    holdAt(5);
    tree.assign(DebugFixture.row(tree, "n"), "n + 41");
    assertEquals("42", DebugFixture.row(tree, "n").text());
    assertTrue(DebugFixture.row(tree, "n").kind().equals("int"));
  }

  @Test
  void aRefusalStandsBelowTheValueAndKeepsWhatWasTyped() {
    holdAt(5);
    ValueRow.Value n = DebugFixture.row(tree, "n");
    tree.assign(n, "\"text\"");
    assertEquals("n = 1", DebugFixture.rows(tree).get(1));
    String refusal = DebugFixture.rows(tree).get(2);
    assertTrue(refusal.startsWith("! Not changed: "), refusal);
    assertEquals("\"text\"", tree.toEdit(n));
    tree.dismiss(n.key());
    assertEquals("1", tree.toEdit(n));
  }

  @Test
  void watchesAreComputedAtEveryStopAndSayWhatIsWrong() {
    debug.addWatch("n * 10");
    debug.addWatch("nothing");
    assertEquals(List.of("n * 10 = ", "nothing = "), DebugFixture.rows(debug.watchTree()));
    holdAt(5);
    List<String> rows = DebugFixture.rows(debug.watchTree());
    assertEquals("n * 10 = 10", rows.get(0));
    assertTrue(rows.get(2).startsWith("! ") && rows.get(2).contains("nothing"), rows.toString());
    debug.steps().over();
    fixture.advance();
    assertEquals("n * 10 = 20 *", DebugFixture.rows(debug.watchTree()).get(0));
  }

  @Test
  void watchesAreChangedRemovedAndRemembered() {
    debug.addWatch(" a\n + b ");
    debug.addWatch("c");
    debug.addWatch("c");
    assertEquals(List.of("a + b", "c"), debug.watches());
    debug.changeWatch("c", "d");
    debug.changeWatch("a + b", " ");
    assertEquals(List.of("d"), new Watches(fixture.settings()).expressions());
  }
}
