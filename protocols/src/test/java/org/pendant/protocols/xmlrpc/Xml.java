package org.pendant.protocols.xmlrpc;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Texts of XML-RPC and HTTP, and the server's side of a connection. */
final class Xml {
  private static final Pattern LENGTH = Pattern.compile("content-length: ([0-9]+)");

  private Xml() {}

  /** An answer with a value, written as XML. */
  static String value(String xml) {
    return "<?xml version=\"1.0\"?><methodResponse><params><param><value>"
        + xml
        + "</value></param></params></methodResponse>";
  }

  static String struct(String... namesAndValues) {
    StringBuilder members = new StringBuilder("<struct>");
    for (int i = 0; i < namesAndValues.length; i += 2) {
      members
          .append("<member><name>")
          .append(namesAndValues[i])
          .append("</name><value>")
          .append(namesAndValues[i + 1])
          .append("</value></member>");
    }
    return members.append("</struct>").toString();
  }

  /** A fault, with members of its struct beside number and text. */
  static String fault(int code, String text, String more) {
    String members =
        struct("faultCode", "<int>" + code + "</int>", "faultString", text)
            .replace("</struct>", more + "</struct>");
    return "<methodResponse><fault><value>" + members + "</value></fault></methodResponse>";
  }

  /** The body of the next request; empty when the client has gone. */
  static String request(Socket client) throws IOException {
    InputStream in = client.getInputStream();
    ByteArrayOutputStream head = new ByteArrayOutputStream();
    while (!head.toString(StandardCharsets.ISO_8859_1).endsWith("\r\n\r\n")) {
      int next = in.read();
      if (next < 0) {
        return "";
      }
      head.write(next);
    }
    Matcher length =
        LENGTH.matcher(head.toString(StandardCharsets.ISO_8859_1).toLowerCase(Locale.ROOT));
    if (!length.find()) {
      throw new IOException("no length");
    }
    return new String(in.readNBytes(Integer.parseInt(length.group(1))), StandardCharsets.UTF_8);
  }

  static void say(Socket client, String text) throws IOException {
    client.getOutputStream().write(text.getBytes(StandardCharsets.UTF_8));
  }

  /** A whole HTTP answer. */
  static String http(String body) {
    return "HTTP/1.1 200 OK\r\nContent-Length: "
        + body.getBytes(StandardCharsets.UTF_8).length
        + "\r\n\r\n"
        + body;
  }
}
