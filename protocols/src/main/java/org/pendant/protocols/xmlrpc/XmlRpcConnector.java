package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.net.URI;
import java.net.URISyntaxException;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.external.RpcConnector;
import org.pendant.controller.external.RpcLink;
import org.pendant.protocols.egress.HostPolicy;
import org.pendant.script.value.ScriptError;

/** Connector to XML-RPC servers for the scripts of one controller. */
public final class XmlRpcConnector implements RpcConnector, AutoCloseable {
  private static final Pattern STREAM =
      Pattern.compile("(?:\\[([0-9A-Fa-f:.]+)]|([^/:\\[\\]\\s]+)):([0-9]{1,5})");

  private static final int HTTP_PORT = 80;
  private static final int MAX_PORT = 65_535;

  private final HostPolicy hostPolicy;
  private final Set<RpcLink> open = ConcurrentHashMap.newKeySet();

  /** Connections that go no further than {@code reach}. */
  public XmlRpcConnector(HostPolicy hostPolicy) {
    this.hostPolicy = hostPolicy;
  }

  @Override
  public RpcLink open(String url) throws ScriptError {
    Matcher stream = STREAM.matcher(url);
    if (stream.matches()) {
      String host = stream.group(1) == null ? stream.group(2) : stream.group(1);
      int port = port(Integer.parseInt(stream.group(3)), url);
      return link(new PacketWire(new RpcConnection(hostPolicy, host, port)));
    }
    URI uri = uri(url);
    int port = uri.getPort() < 0 ? HTTP_PORT : port(uri.getPort(), url);
    String host = uri.getHost();
    if (host.startsWith("[")) {
      host = host.substring(1, host.length() - 1);
    }
    String path = uri.getRawPath().isEmpty() ? "/" : uri.getRawPath();
    String target = uri.getRawQuery() == null ? path : path + "?" + uri.getRawQuery();
    return link(
        new HttpWire(new RpcConnection(hostPolicy, host, port), uri.getRawAuthority(), target));
  }

  private RpcLink link(Wire wire) {
    XmlRpcLink link = new XmlRpcLink(wire, open::remove);
    open.add(link);
    return link;
  }

  /** Ends all connections and the calls that are under way. */
  @Override
  public void close() {
    open.forEach(RpcLink::close);
  }

  private static URI uri(String url) throws ScriptError {
    try {
      URI uri = new URI(url);
      if ("http".equalsIgnoreCase(uri.getScheme())
          && uri.getHost() != null
          && uri.getRawUserInfo() == null) {
        return uri;
      }
    } catch (URISyntaxException e) {
      throw wrong(url);
    }
    throw wrong(url);
  }

  private static int port(int port, String url) throws ScriptError {
    if (port < 1 || port > MAX_PORT) {
      throw wrong(url);
    }
    return port;
  }

  private static ScriptError wrong(String url) {
    return new ScriptError(
        "value-out-of-range",
        text("wrongUrl", url.length() > 200 ? url.substring(0, 200) + "..." : url));
  }
}
