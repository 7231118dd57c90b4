package org.pendant.protocols.wire;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.function.Function;

/**
 * Line dissector: of protocols of lines of text in both directions.
 *
 * @param effect what a line of a client does
 */
public record LineDissector(Function<String, Optional<String>> effect) implements Dissector {

  @Override
  public int length(Direction direction, ByteBuffer bytes) {
    for (int i = bytes.position(); i < bytes.limit(); i++) {
      if (bytes.get(i) == '\n') {
        return i + 1 - bytes.position();
      }
    }
    return MORE;
  }

  @Override
  public Reading read(Direction direction, ByteBuffer message) {
    String line = Dissector.text(message).stripTrailing();
    String type = direction == Direction.IN ? "line" : "answer";
    Optional<String> does = direction == Direction.IN ? effect.apply(line) : Optional.empty();
    Reading reading = Reading.quoting(type, line, () -> Fields.of("text", line));
    return does.map(reading::doing).orElse(reading);
  }
}
