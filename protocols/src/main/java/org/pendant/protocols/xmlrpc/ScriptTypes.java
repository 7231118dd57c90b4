package org.pendant.protocols.xmlrpc;

import java.math.BigDecimal;
import org.apache.ws.commons.util.NamespaceContextImpl;
import org.apache.xmlrpc.common.TypeFactoryImpl;
import org.apache.xmlrpc.common.XmlRpcController;
import org.apache.xmlrpc.common.XmlRpcStreamConfig;
import org.apache.xmlrpc.parser.I8Parser;
import org.apache.xmlrpc.parser.NullParser;
import org.apache.xmlrpc.parser.TypeParser;
import org.apache.xmlrpc.serializer.TypeSerializer;
import org.apache.xmlrpc.serializer.TypeSerializerImpl;
import org.xml.sax.ContentHandler;
import org.xml.sax.SAXException;

/**
 * Script types: the types of XML-RPC as scripts need them: structs keep the order of their members,
 * and the two types that many servers add, {@code nil} and {@code i8}, are understood.
 */
final class ScriptTypes extends TypeFactoryImpl {
  private static final TypeSerializer PLAIN_DOUBLE = new PlainDouble();

  ScriptTypes(XmlRpcController controller) {
    super(controller);
  }

  @Override
  public TypeParser getParser(
      XmlRpcStreamConfig config, NamespaceContextImpl context, String uri, String name) {
    if (uri != null && uri.isEmpty()) {
      switch (name) {
        case "struct" -> {
          return new StructParser(config, context, this);
        }
        case "nil" -> {
          return new NullParser();
        }
        case "i8" -> {
          return new I8Parser();
        }
        default -> {
          // the library's
        }
      }
    }
    return super.getParser(config, context, uri, name);
  }

  @Override
  public TypeSerializer getSerializer(XmlRpcStreamConfig config, Object value) throws SAXException {
    return value instanceof Double ? PLAIN_DOUBLE : super.getSerializer(config, value);
  }

  /** XML-RPC knows no exponents. */
  private static final class PlainDouble extends TypeSerializerImpl {
    @Override
    public void write(ContentHandler handler, Object value) throws SAXException {
      write(handler, "double", BigDecimal.valueOf((Double) value).toPlainString());
    }
  }
}
