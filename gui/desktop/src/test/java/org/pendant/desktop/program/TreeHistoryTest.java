package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.project.program.ProgramTree;

final class TreeHistoryTest {
  private long nowMs;
  private final TreeHistory history = new TreeHistory(() -> nowMs);
  private final ProgramTree first = Trees.of(Trees.comment("1"));
  private final ProgramTree second = Trees.of(Trees.comment("2"));
  private final ProgramTree third = Trees.of(Trees.comment("3"));

  @Test
  void takesChangesBackAndDoesThemAgain() {
    history.changing("A", 0, first);
    history.changing("B", 0, second);
    assertEquals(Optional.of("B"), history.undoes());
    assertEquals(second, history.undo(third).orElseThrow().tree());
    assertEquals(first, history.undo(second).orElseThrow().tree());
    assertTrue(history.undo(first).isEmpty());
    assertEquals(Optional.of("A"), history.redoes());
    assertEquals(second, history.redo(first).orElseThrow().tree());
    assertEquals(third, history.redo(second).orElseThrow().tree());
    assertTrue(history.redo(third).isEmpty());
  }

  @Test
  void quickChangesOfOneFieldAreOne() {
    history.changing("Change text", 2, first);
    nowMs += 400;
    history.changing("Change text", 2, second);
    assertEquals(first, history.undo(third).orElseThrow().tree());
    assertTrue(history.undoes().isEmpty());
  }

  @Test
  void changesAfterAPauseOfOtherNodesOrWithOtherWordsAreSeparate() {
    history.changing("Change text", 2, first);
    nowMs += 5000;
    history.changing("Change text", 2, second);
    assertEquals(second, history.undo(third).orElseThrow().tree());
    history.changing("Change text", 3, second);
    history.changing("Change kind", 3, third);
    assertEquals(third, history.undo(first).orElseThrow().tree());
    assertEquals(second, history.undo(third).orElseThrow().tree());
  }

  @Test
  void changesWithoutANodeAreNeverOne() {
    history.changing("Delete", 0, first);
    history.changing("Delete", 0, second);
    assertEquals(second, history.undo(third).orElseThrow().tree());
    assertEquals(Optional.of("Delete"), history.undoes());
  }

  @Test
  void whatIsTypedAfterAnUndoIsAChangeOfItsOwn() {
    history.changing("Change text", 2, first);
    history.undo(second);
    history.changing("Change text", 2, first);
    assertTrue(history.redoes().isEmpty());
    assertEquals(first, history.undo(third).orElseThrow().tree());
  }
}
