package org.pendant.protocols.trace;

import java.io.IOException;
import java.io.UncheckedIOException;

/** JSON sink: a trace as lines of JSON. */
final class JsonSink implements TraceSink {
  private final JsonWriter writer;
  private final MessageReader reader = new MessageReader(this::write);

  JsonSink(JsonWriter writer) {
    this.writer = writer;
  }

  private void write(WireMessage message) {
    try {
      writer.write(message);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void take(WireEvent event) throws IOException {
    try {
      reader.take(event);
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  @Override
  public void leftOut(long count, long epochUs) throws IOException {
    writer.writeLeftOut(count, epochUs);
  }

  @Override
  public void flush() throws IOException {
    writer.flush();
  }

  @Override
  public void close() throws IOException {
    writer.close();
  }
}
