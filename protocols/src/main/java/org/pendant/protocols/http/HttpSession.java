package org.pendant.protocols.http;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.ProtocolException;
import org.pendant.protocols.net.Session;

/** The requests of one client, answered in their order. */
public final class HttpSession implements Session {
  private final Connection connection;
  private final HttpService service;
  private final HttpCutter cutter = new HttpCutter();
  private boolean ended;

  /** A client that has just connected. */
  public HttpSession(Connection connection, HttpService service) {
    this.connection = connection;
    this.service = service;
  }

  @Override
  public void received(ByteBuffer bytes) throws ProtocolException {
    try {
      for (Optional<HttpCall> call = next(bytes); call.isPresent(); call = next(bytes)) {
        connection.send(service.answer(call.get()).bytes(call.get().keep()));
        if (!call.get().keep()) {
          ended = true;
          connection.closeAfterSending();
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Nothing counts behind the last request that a client has announced. */
  private Optional<HttpCall> next(ByteBuffer bytes) throws ProtocolException {
    return ended ? Optional.empty() : cutter.next(bytes);
  }
}
