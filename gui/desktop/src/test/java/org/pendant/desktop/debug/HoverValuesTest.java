package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.session.ProgramDocument;

final class HoverValuesTest {
  private final DebugFixture fixture =
      new DebugFixture(
          "count = 1",
          "def twice(n):",
          "  result = 2 * n",
          "  return result",
          "end",
          "count = twice(20)",
          "sync()",
          "count = 7");
  private final HoverValues values = fixture.hoverValues();

  @Test
  void aPausedProgramTellsTheValuesOfTheCallThatIsLookedAt() {
    fixture.breakAt(4);
    fixture.run();
    assertEquals(Optional.of("20"), values.of(fixture.document(), "n"));
    assertEquals(Optional.of("40"), values.of(fixture.document(), "result"));
    assertEquals(Optional.of("1"), values.of(fixture.document(), "count"));
    assertEquals(Optional.empty(), values.of(fixture.document(), "sync"));
  }

  @Test
  void aProgramThatHasEndedTellsTheLastOnes() {
    fixture.run();
    assertEquals(Optional.of("7"), values.of(fixture.document(), "count"));
  }

  @Test
  void otherProgramsTellNothing() {
    fixture.run();
    assertEquals(
        Optional.empty(),
        values.of(ProgramDocument.untitled("other.script", "count = 3\n"), "count"));
  }
}
