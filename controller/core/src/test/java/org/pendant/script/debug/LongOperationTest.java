package org.pendant.script.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.Ending;

/** A program may be held while an operation is half done. */
class LongOperationTest {
  private static final String TEXT =
      """
      def prog():
        a = make_list(1000000, 1, 1000000)
        b = make_list(1000000, 5, 1000000)
        b = a + a
        textmsg(b[999999])
      end
      """;

  private final DebugFixture fixture = new DebugFixture();

  /** Holds it in the middle of line 4. */
  private void holdInTheMiddle() {
    fixture.start(TEXT);
    while (fixture.machine.line() < 4) {
      fixture.advance(1);
    }
    fixture.advance(1);
    fixture.debugger.pause();
    fixture.go();
    assertEquals(4, fixture.machine.line());
  }

  @Test
  void whatItChangesHasItsOldValue() throws ScriptError {
    holdInTheMiddle();
    assertEquals("5", fixture.debugger.evaluate(0, 1, "b[999999]").text());
    assertEquals("1", fixture.debugger.evaluate(0, 1, "a[0]").text());
  }

  @Test
  void stepOverFinishesIt() {
    holdInTheMiddle();
    fixture.over();
    assertEquals(5, fixture.machine.line());
    fixture.over();
    assertEquals(List.of("2"), fixture.messages());
  }

  @Test
  void continuingFinishesIt() {
    holdInTheMiddle();
    fixture.resume();
    assertInstanceOf(Ending.Finished.class, fixture.ending());
    assertEquals(List.of("2"), fixture.messages());
  }

  @Test
  void variableThatIsChangedMeanwhileDoesNotReachIt() throws ScriptError {
    holdInTheMiddle();
    fixture.debugger.assign(0, 1, "a[999999]", "50");
    fixture.resume();
    assertEquals(List.of("2"), fixture.messages());
  }
}
