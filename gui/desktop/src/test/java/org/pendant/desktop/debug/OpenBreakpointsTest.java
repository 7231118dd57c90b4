package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.pendant.script.debug.Breakpoint;

final class OpenBreakpointsTest {
  private final DebugFixture fixture =
      new DebugFixture(
          "def program():",
          "  i = 0",
          "  while i < 5:",
          "    i = i + 1",
          "",
          "    sync()",
          "  end",
          "end");
  private final DebugPresenter debug = fixture.debug();
  private final OpenBreakpoints openBreakpoints = debug.breakpoints();

  @Test
  void aConditionSaysWhereTheProgramStops() {
    fixture.breakAt(4);
    openBreakpoints.change(Breakpoint.at(4).when("i == 3"));
    debug.addWatch("i");
    fixture.run();
    assertEquals("i = 3", DebugFixture.rows(debug.watchTree()).getFirst());
  }

  @Test
  void hitsAreCountedAndTheFirstOnesPassed() {
    fixture.breakAt(4);
    openBreakpoints.change(Breakpoint.at(4).fromHit(3));
    fixture.run();
    assertEquals("Breakpoint on line 4, hit 3", debug.stopText());
    assertEquals(3, openBreakpoints.state(openBreakpoints.all().getFirst()).orElseThrow().hits());
  }

  @Test
  void theHitsOfALogpointAreCountedThoughItStopsNothing() {
    fixture.breakAt(4);
    openBreakpoints.change(Breakpoint.at(4).logging("i is {i}"));
    fixture.run();
    assertFalse(debug.held());
    debug.lookAtHits();
    assertEquals(5, openBreakpoints.state(openBreakpoints.all().getFirst()).orElseThrow().hits());
  }

  @Test
  void aDisabledBreakpointStopsNothing() {
    fixture.breakAt(4);
    openBreakpoints.change(Breakpoint.at(4).disabled());
    fixture.run();
    assertFalse(debug.held());
  }

  @Test
  void breakpointsChangeWhileTheProgramIsHeld() {
    fixture.breakAt(4);
    fixture.run();
    fixture.breakAt(6);
    fixture.resume();
    fixture.advance();
    assertEquals("Breakpoint on line 6", debug.stopText());
  }

  @Test
  void aBreakpointOnAnEmptyLineTellsWhereItStops() {
    fixture.breakAt(5);
    fixture.run();
    assertEquals(
        OptionalInt.of(6),
        openBreakpoints.state(openBreakpoints.all().getFirst()).orElseThrow().statementLine());
    assertEquals("5 (stops on 6)", new Shown(openBreakpoints).place(), "the table says so");
  }

  /** The table with the open breakpoints. */
  private record Shown(OpenBreakpoints openBreakpoints) {
    String place() {
      BreakpointTableModel model = new BreakpointTableModel(openBreakpoints);
      model.show();
      return model.getValueAt(0, BreakpointTableModel.LINE).toString();
    }
  }

  @Test
  void conditionsMoveWithTheirLines() {
    BreakpointList list = new BreakpointList();
    list.set(Breakpoint.at(4).when("i == 3"));
    list.set(Breakpoint.at(9));
    list.move(new TreeMap<>(Map.of(4, 9, 9, 14)));
    assertEquals(List.of(Breakpoint.at(9).when("i == 3"), Breakpoint.at(14)), list.all());
  }

  @Test
  void aNumberOfAHitIsAWholeNumberAboveZero() {
    assertEquals("", BreakpointTableModel.hitRefusal(" 12 "));
    assertEquals(
        "From hit is '0', must be a number, such as 5, or >= 5, > 5, == 5, <= 5, < 5, % 5",
        BreakpointTableModel.hitRefusal("0"));
  }

  @Test
  void breakpointsOfAnEditorThatIsAttachedAreLeftToIt() {
    fixture.ask(debugger -> debugger.share(true));
    fixture.ask(debugger -> debugger.set(Breakpoint.at(6)));
    fixture.breakAt(4);
    openBreakpoints.removeAll();
    fixture.run();
    assertEquals("Breakpoint on line 6", debug.stopText());
  }

  @Test
  void everyBreakpointCanBeRemoved() {
    fixture.breakAt(4, 6);
    openBreakpoints.removeAll();
    assertTrue(openBreakpoints.all().isEmpty());
    fixture.run();
    assertFalse(debug.held());
  }
}
