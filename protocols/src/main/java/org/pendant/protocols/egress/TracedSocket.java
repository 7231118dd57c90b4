package org.pendant.protocols.egress;

import java.io.FilterInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.pendant.protocols.net.WireEnd;
import org.pendant.protocols.net.WireTap;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Terms;

/** Socket that a tap hears, if there is one. One thread reads and one writes. */
final class TracedSocket extends Socket implements WireEnd {
  private final Traced traced;
  private final AtomicBoolean told = new AtomicBoolean();
  private volatile InetSocketAddress here = new InetSocketAddress(0);
  private volatile InetSocketAddress there = new InetSocketAddress(0);
  private volatile long received;
  private volatile long sent;

  TracedSocket(Traced traced) {
    this.traced = traced;
  }

  /** It is connected. */
  void opened() {
    here = (InetSocketAddress) getLocalSocketAddress();
    there = (InetSocketAddress) getRemoteSocketAddress();
    told.set(true);
    traced.tap().get().ifPresent(each -> each.opened(this));
  }

  @Override
  public InputStream getInputStream() throws IOException {
    return new FilterInputStream(super.getInputStream()) {
      @Override
      public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : Byte.toUnsignedInt(one[0]);
      }

      @Override
      public int read(byte[] bytes, int from, int most) throws IOException {
        int count = in.read(bytes, from, most);
        if (count > 0) {
          hasCome(bytes, from, count);
        }
        return count;
      }
    };
  }

  private void hasCome(byte[] bytes, int from, int count) {
    long before = received;
    received = before + count;
    Optional<WireTap> tap = traced.tap().get();
    if (tap.isPresent()) {
      tap.get().received(this, before, ByteBuffer.wrap(bytes, from, count).slice());
    }
  }

  @Override
  public OutputStream getOutputStream() throws IOException {
    return new FilterOutputStream(super.getOutputStream()) {
      @Override
      public void write(int one) throws IOException {
        write(new byte[] {(byte) one}, 0, 1);
      }

      @Override
      public void write(byte[] bytes, int from, int count) throws IOException {
        goesOut(bytes, from, count);
        out.write(bytes, from, count);
      }
    };
  }

  private void goesOut(byte[] bytes, int from, int count) {
    long before = sent;
    sent = before + count;
    Optional<WireTap> tap = traced.tap().get();
    if (tap.isPresent()) {
      tap.get().sent(this, before, Arrays.copyOfRange(bytes, from, from + count));
    }
  }

  @Override
  public void close() throws IOException {
    super.close();
    if (told.getAndSet(false)) {
      traced.tap().get().ifPresent(each -> each.closed(this));
    }
  }

  @Override
  public String portName() {
    return traced.name();
  }

  @Override
  public InetSocketAddress local() {
    return here;
  }

  @Override
  public InetSocketAddress peer() {
    return there;
  }

  @Override
  public boolean outgoing() {
    return true;
  }

  @Override
  public Optional<Terms> terms() {
    return Optional.empty();
  }

  @Override
  public Dissector dissector() {
    return traced.dissector().get();
  }
}
