package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.util.LinkedHashMap;
import java.util.Map;
import org.apache.ws.commons.util.NamespaceContextImpl;
import org.apache.xmlrpc.common.TypeFactory;
import org.apache.xmlrpc.common.XmlRpcStreamConfig;
import org.apache.xmlrpc.parser.RecursiveTypeParserImpl;
import org.xml.sax.Attributes;
import org.xml.sax.SAXException;

/**
 * Struct parser: reads a struct with its members in their order, which the library's own parser
 * loses.
 */
final class StructParser extends RecursiveTypeParserImpl {
  private static final int STRUCT = 0;
  private static final int MEMBER = 1;
  private static final int NAME_OR_VALUE = 2;

  private final Map<String, Object> members = new LinkedHashMap<>();
  private final StringBuilder name = new StringBuilder();
  private int level;
  private boolean inName;
  private boolean named;
  private boolean valued;
  private Object value;

  StructParser(XmlRpcStreamConfig config, NamespaceContextImpl context, TypeFactory types) {
    super(config, context, types);
  }

  @Override
  protected void addResult(Object result) {
    value = result;
    valued = true;
  }

  @Override
  public void startElement(String uri, String local, String qualified, Attributes attributes)
      throws SAXException {
    switch (level++) {
      case STRUCT -> expect(local.equals("struct"));
      case MEMBER -> {
        expect(local.equals("member"));
        named = false;
        valued = false;
        name.setLength(0);
      }
      case NAME_OR_VALUE -> {
        inName = local.equals("name");
        expect(inName ? !named : named && !valued && local.equals("value"));
        named = true;
        if (!inName) {
          startValueTag();
        }
      }
      default -> super.startElement(uri, local, qualified, attributes);
    }
  }

  @Override
  public void characters(char[] text, int start, int length) throws SAXException {
    if (inName) {
      name.append(text, start, length);
    } else {
      super.characters(text, start, length);
    }
  }

  @Override
  public void endElement(String uri, String local, String qualified) throws SAXException {
    switch (--level) {
      case STRUCT -> setResult(members);
      case MEMBER -> {
        expect(valued);
        members.put(name.toString(), value);
      }
      case NAME_OR_VALUE -> {
        if (!inName) {
          endValueTag();
        }
        inName = false;
      }
      default -> super.endElement(uri, local, qualified);
    }
  }

  private static void expect(boolean right) throws SAXException {
    if (!right) {
      throw new SAXException(text("structWithoutMembers"));
    }
  }
}
