package org.pendant.desktop.debug;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.GeneratedScript.NodeLines;

/**
 * Line correspondence: which lines of the text that runs are which of the text that people see;
 * both count from 1.
 */
public interface RunLines {
  /** The text that runs is what people see. */
  RunLines SAME =
      new RunLines() {
        @Override
        public int toShown(int run) {
          return run;
        }

        @Override
        public List<Integer> toRun(int shown) {
          return List.of(shown);
        }
      };

  /** The line that people see for line {@code run} of what runs; 0 stays 0. */
  int toShown(int run);

  /** The lines of what runs for line {@code shown}, in their order; none if it is not in there. */
  List<Integer> toRun(int shown);

  /** What else is to be said of where line {@code run} of what runs comes from. */
  default Optional<String> origin(int run) {
    return Optional.empty();
  }

  /** As the other of that name, where no driver has sent anything. */
  static RunLines between(GeneratedScript run, GeneratedScript shown) {
    return between(run, shown, Optional.empty());
  }

  /**
   * Of two scripts of one tree, where one runs that begins in its middle, or has what a driver has
   * sent: lines belong together if they stand as far below the first line of the same node.
   *
   * @param sent what is in the one that runs
   */
  static RunLines between(
      GeneratedScript run, GeneratedScript shown, Optional<ControlScript> sent) {
    LineMap outside = LineMap.between(run.text(), shown.text());
    return new RunLines() {
      @Override
      public Optional<String> origin(int line) {
        OptionalInt number = run.receivedLine(line);
        return number.isPresent()
            ? sent.map(each -> each.place(number.getAsInt()))
            : Optional.empty();
      }

      @Override
      public int toShown(int line) {
        Optional<NodeLines> place = run.at(line);
        return place.isEmpty()
            ? outside.toNow(line)
            : shown.of(place.get().key()).map(same -> moved(line, place.get(), same)).orElse(0);
      }

      @Override
      public List<Integer> toRun(int line) {
        return shown.at(line).stream()
            .flatMap(
                place ->
                    run.places().stream()
                        .filter(same -> same.key() == place.key())
                        .map(same -> moved(line, place, same)))
            .sorted()
            .distinct()
            .toList();
      }
    };
  }

  private static int moved(int line, NodeLines from, NodeLines to) {
    return Math.clamp((long) line - from.first() + to.first(), 1, to.last());
  }
}
