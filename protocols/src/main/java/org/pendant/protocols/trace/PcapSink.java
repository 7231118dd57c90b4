package org.pendant.protocols.trace;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import org.pendant.protocols.net.WireEnd;
import org.pendant.protocols.wire.Direction;

/** Pcap sink: a trace as packets. What was left out is a gap in the numbers of its connection. */
final class PcapSink implements TraceSink {
  private final PcapWriter writer;
  private final Map<WireEnd, TcpStream> streams = new HashMap<>();

  PcapSink(PcapWriter writer) {
    this.writer = writer;
  }

  @Override
  public void take(WireEvent event) throws IOException {
    WireEnd connection = event.connection();
    TcpStream stream =
        streams.computeIfAbsent(connection, absent -> new TcpStream(Peers.of(absent)));
    switch (event.kind()) {
      case OPENED -> stream.open(writer, event.epochUs(), connection.outgoing());
      case RECEIVED -> write(stream, Direction.IN, event);
      case SENT -> write(stream, Direction.OUT, event);
      case CLOSED -> {
        stream.end(writer, event.epochUs());
        streams.remove(connection);
      }
    }
  }

  private void write(TcpStream stream, Direction direction, WireEvent event) throws IOException {
    ByteBuffer bytes = event.bytes().duplicate();
    stream.write(writer, event.epochUs(), direction, event.before(), bytes);
  }

  @Override
  public void leftOut(long count, long epochUs) {
    // the numbers of the next packet show it
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
