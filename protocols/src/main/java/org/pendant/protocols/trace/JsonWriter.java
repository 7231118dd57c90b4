package org.pendant.protocols.trace;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.StringWriter;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Collection;
import java.util.HexFormat;
import java.util.Map;
import org.pendant.protocols.wire.Reading;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;

/** JSON writer: messages as JSON, an object a line. */
public final class JsonWriter implements Closeable {
  /** Of a longer message the first bytes are written. */
  public static final int MAX_HEX_BYTES = 4096;

  private final OutputStream file;
  private final JsonFactory json = new JsonFactory();
  private final StringWriter line = new StringWriter();

  /** Writes to {@code file}, and closes it. */
  public JsonWriter(OutputStream file) {
    this.file = file;
  }

  /** Writes a message. */
  public void write(WireMessage message) throws IOException {
    writeLine(
        out -> {
          Reading reading = message.reading();
          out.writeStringProperty("time", time(message.epochUs()));
          out.writeNumberProperty("robot_s", message.robotTimeS());
          out.writeStringProperty("client", message.peers().client());
          out.writeStringProperty("port", message.peers().port());
          out.writeNumberProperty("number", message.peers().local().getPort());
          out.writeStringProperty("direction", message.direction().word());
          out.writeStringProperty("type", reading.type());
          out.writeStringProperty("summary", reading.summary());
          reading.effect().ifPresent(effect -> out.writeStringProperty("effect", effect));
          out.writeName("fields");
          writeValue(out, message.fields());
          out.writeNumberProperty("length", message.bytes().remaining());
          out.writeStringProperty("bytes", hex(message.bytes()));
        });
  }

  /** Writes that messages are missing here. */
  void writeLeftOut(long count, long epochUs) throws IOException {
    writeLine(
        out -> {
          out.writeStringProperty("time", time(epochUs));
          out.writeStringProperty("type", "left-out");
          out.writeNumberProperty("count", count);
        });
  }

  /** Fills an object. */
  private interface Members {
    void write(JsonGenerator out);
  }

  private void writeLine(Members members) throws IOException {
    line.getBuffer().setLength(0);
    try (JsonGenerator out = json.createGenerator(ObjectWriteContext.empty(), line)) {
      out.writeStartObject();
      members.write(out);
      out.writeEndObject();
    }
    line.append('\n');
    file.write(line.toString().getBytes(StandardCharsets.UTF_8));
  }

  private static String time(long epochUs) {
    return Instant.EPOCH.plus(epochUs, ChronoUnit.MICROS).toString();
  }

  private static String hex(ByteBuffer bytes) {
    byte[] first = new byte[Math.min(MAX_HEX_BYTES, bytes.remaining())];
    bytes.duplicate().get(first);
    return HexFormat.of().formatHex(first);
  }

  private static void writeValue(JsonGenerator out, Object value) {
    switch (value) {
      case Map<?, ?> members -> {
        out.writeStartObject();
        members.forEach(
            (name, each) -> {
              out.writeName(name.toString());
              writeValue(out, each);
            });
        out.writeEndObject();
      }
      case Collection<?> items -> {
        out.writeStartArray();
        items.forEach(each -> writeValue(out, each));
        out.writeEndArray();
      }
      case double[] numbers -> {
        out.writeStartArray();
        for (double each : numbers) {
          out.writeNumber(each);
        }
        out.writeEndArray();
      }
      case Double number -> out.writeNumber(number);
      case Long number -> out.writeNumber(number);
      case Integer number -> out.writeNumber(number);
      case Boolean truth -> out.writeBoolean(truth);
      default -> out.writeString(value.toString());
    }
  }

  /** Puts what was written where others see it. */
  void flush() throws IOException {
    file.flush();
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
