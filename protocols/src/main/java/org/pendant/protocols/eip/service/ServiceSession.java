package org.pendant.protocols.eip.service;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.ProtocolException;
import org.pendant.protocols.net.Session;

/** The calls of one client, by HTTP. */
final class ServiceSession implements Session {
  private final Connection connection;
  private final AssemblyCalls calls;
  private final HttpCutter cutter = new HttpCutter();

  ServiceSession(Connection connection, AssemblyCalls calls) {
    this.connection = connection;
    this.calls = calls;
  }

  @Override
  public void received(ByteBuffer bytes) throws ProtocolException {
    try {
      for (Optional<HttpCall> call = cutter.next(bytes);
          call.isPresent();
          call = cutter.next(bytes)) {
        answer(call.get());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void answer(HttpCall call) throws InterruptedException {
    boolean post = call.method().equals("POST");
    byte[] body =
        post
            ? calls.answer(call.body()).getBytes(StandardCharsets.UTF_8)
            : "only POST\n".getBytes(StandardCharsets.UTF_8);
    String head =
        (post ? "HTTP/1.1 200 OK\r\n" : "HTTP/1.1 405 Method Not Allowed\r\nAllow: POST\r\n")
            + "Server: Pendant\r\nContent-Type: "
            + (post ? "text/xml" : "text/plain")
            + "\r\nContent-Length: "
            + body.length
            + (call.keep() ? "\r\n\r\n" : "\r\nConnection: close\r\n\r\n");
    connection.send(head.getBytes(StandardCharsets.ISO_8859_1));
    connection.send(body);
    if (!call.keep()) {
      connection.closeAfterSending();
    }
  }
}
