package org.pendant.protocols.xmlrpc;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Objects;
import org.apache.xmlrpc.XmlRpcException;
import org.apache.xmlrpc.client.XmlRpcClient;
import org.apache.xmlrpc.client.XmlRpcClientConfigImpl;
import org.apache.xmlrpc.parser.XmlRpcRequestParser;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.XMLReader;

/** Call reader: reads the calls that a server of ours gets. */
public final class CallReader {
  private CallReader() {}

  /**
   * What is called.
   *
   * @param parameters of the types that the library has for those of XML-RPC
   */
  public record Call(String method, List<Object> parameters) {
    /** Copies the list. */
    public Call {
      parameters = List.copyOf(parameters);
    }
  }

  /**
   * Reads a call.
   *
   * @throws XmlRpcException if it is none
   */
  public static Call read(ByteBuffer xml) throws XmlRpcException {
    byte[] bytes = new byte[xml.remaining()];
    xml.duplicate().get(bytes);
    Parser parser = new Parser();
    XMLReader reader = SafeXml.reader();
    reader.setContentHandler(parser);
    try {
      reader.parse(new InputSource(new ByteArrayInputStream(bytes)));
    } catch (IOException | SAXException e) {
      throw new XmlRpcException("the call is not XML-RPC: " + e.getMessage(), e);
    }
    return parser.call();
  }

  private static final class Parser extends XmlRpcRequestParser {
    private int depth;

    Parser() {
      super(new XmlRpcClientConfigImpl(), new ScriptTypes(new XmlRpcClient()));
    }

    @Override
    public void startElement(String uri, String name, String qualified, Attributes attributes)
        throws SAXException {
      depth++;
      if (depth > SafeXml.DEEPEST) {
        throw new SAXException("more than " + SafeXml.DEEPEST + " elements within each other");
      }
      super.startElement(uri, name, qualified, attributes);
    }

    @Override
    public void endElement(String uri, String name, String qualified) throws SAXException {
      depth--;
      super.endElement(uri, name, qualified);
    }

    Call call() throws XmlRpcException {
      List<?> parameters = getParams() == null ? List.of() : getParams();
      if (getMethodName() == null || parameters.stream().anyMatch(Objects::isNull)) {
        throw new XmlRpcException("the call has no method, or None as a parameter");
      }
      return new Call(getMethodName(), List.copyOf(parameters));
    }
  }
}
