package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.io.IOException;
import java.nio.charset.StandardCharsets;

/** HTTP wire: HTTP/1.1 with a connection that stays open as long as the server likes. */
final class HttpWire implements Wire {
  private final RpcConnection line;
  private final String authority;
  private final String target;

  /**
   * Calls by POST.
   *
   * @param authority host and port as the script wrote them
   * @param target path and query
   */
  HttpWire(RpcConnection line, String authority, String target) {
    this.line = line;
    this.authority = authority;
    this.target = target;
  }

  /** Not kept: a server that serves one connection at a time would be blocked by it. */
  @Override
  public void probe() throws IOException {
    line.connect();
    line.close();
  }

  @Override
  public byte[] exchange(byte[] call) throws IOException {
    byte[] request = request(call);
    try {
      if (line.connected() && begins(request)) {
        return answer();
      }
      // the first call, or the server has meanwhile closed a connection that was kept
      line.close();
      line.connect();
      line.send(request);
      if (!line.awaitAnswer()) {
        throw new IOException(text("closedWithoutAnswer"));
      }
      return answer();
    } catch (IOException e) {
      line.close();
      throw e;
    }
  }

  /** Sends by a connection that was kept, and tells whether an answer begins. */
  private boolean begins(byte[] request) throws IOException {
    try {
      line.send(request);
      return line.awaitAnswer();
    } catch (IOException e) {
      if (Thread.currentThread().isInterrupted()) {
        throw e;
      }
      return false;
    }
  }

  private byte[] request(byte[] body) {
    byte[] head =
        ("POST "
                + target
                + " HTTP/1.1\r\nHost: "
                + authority
                + "\r\nUser-Agent: Pendant\r\nContent-Type: text/xml\r\nContent-Length: "
                + body.length
                + "\r\n\r\n")
            .getBytes(StandardCharsets.ISO_8859_1);
    byte[] request = new byte[head.length + body.length];
    System.arraycopy(head, 0, request, 0, head.length);
    System.arraycopy(body, 0, request, head.length, body.length);
    return request;
  }

  private byte[] answer() throws IOException {
    HttpAnswer answer = HttpAnswer.read(line::read);
    if (!answer.keepsConnection()) {
      line.close();
    }
    return answer.body();
  }

  @Override
  public void close() {
    line.close();
  }
}
