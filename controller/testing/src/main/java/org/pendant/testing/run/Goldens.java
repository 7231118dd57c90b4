package org.pendant.testing.run;

import java.io.Closeable;
import java.util.Optional;
import org.pendant.controller.Drive;
import org.pendant.controller.state.ControllerState;
import org.pendant.testing.source.TestCase;

/**
 * Goldens: recordings of tests that are marked with {@code @golden}, which each run of them is
 * compared with. Any thread may ask.
 */
@FunctionalInterface
public interface Goldens {
  /** A test that is marked is about to run. */
  Run begins(TestCase test);

  /** Nothing is compared. */
  Goldens NONE =
      _ ->
          new Run() {
            @Override
            public void begins(Drive drive) {}

            @Override
            public void sees(ControllerState state) {}

            @Override
            public Optional<Problem> passed() {
              return Optional.empty();
            }

            @Override
            public void close() {}
          };

  /** One run of a test, which it sees; closed when the test has ended. */
  interface Run extends TestObserver, Closeable {
    /** The test has passed by itself. */
    Optional<Problem> passed();

    @Override
    void close();
  }

  /**
   * Why the test is red all the same.
   *
   * @param code stable kebab-case identifier, such as {@code golden-differs}
   * @param message for people
   * @param line that its program, or the one that it watches, was at; 0 where no line is to blame
   * @param program name of the text that has this line
   */
  record Problem(String code, String message, int line, String program) {}
}
