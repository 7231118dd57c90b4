package org.pendant.protocols.http;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.ProtocolException;
import org.pendant.protocols.net.Session;

/** HTTP session: the requests of one client, answered in their order. */
public final class HttpSession implements Session {
  private static final byte[] GO_ON =
      "HTTP/1.1 100 Continue\r\n\r\n".getBytes(StandardCharsets.US_ASCII);

  private final Connection connection;
  private final HttpService service;
  private final HttpCutter cutter;
  private boolean ended;

  /** A client that has just connected. */
  public HttpSession(Connection connection, HttpService service) {
    this.connection = connection;
    this.service = service;
    cutter = new HttpCutter(service::bodyLimit);
  }

  @Override
  public void received(ByteBuffer bytes) throws ProtocolException {
    try {
      for (Optional<HttpCall> call = next(bytes); call.isPresent(); call = next(bytes)) {
        byte[] answer = service.answer(call.get()).bytes(call.get().keep());
        cutter.forget();
        connection.send(answer);
        if (!call.get().keep()) {
          ended = true;
          connection.closeAfterSending();
        }
      }
      if (cutter.tellToGoOn()) {
        connection.send(GO_ON.clone());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void closed() {
    cutter.forget();
  }

  /** Nothing counts after the last request that a client has announced. */
  private Optional<HttpCall> next(ByteBuffer bytes) throws ProtocolException {
    return ended ? Optional.empty() : cutter.next(bytes);
  }
}
