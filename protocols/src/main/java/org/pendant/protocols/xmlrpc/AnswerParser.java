package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.util.Map;
import java.util.Optional;
import org.apache.xmlrpc.XmlRpcException;
import org.apache.xmlrpc.common.TypeFactory;
import org.apache.xmlrpc.common.XmlRpcStreamRequestConfig;
import org.apache.xmlrpc.parser.XmlRpcResponseParser;
import org.xml.sax.Attributes;
import org.xml.sax.SAXException;

/** Answer parser: reads an answer; of a fault nothing but its number and its text. */
final class AnswerParser extends XmlRpcResponseParser {
  private int depth;
  private Optional<XmlRpcFault> fault = Optional.empty();

  AnswerParser(XmlRpcStreamRequestConfig config, TypeFactory types) {
    super(config, types);
  }

  @Override
  public void startElement(String uri, String name, String qualified, Attributes attributes)
      throws SAXException {
    depth++;
    if (depth > SafeXml.DEEPEST) {
      throw new SAXException(text("tooDeep", SafeXml.DEEPEST));
    }
    super.startElement(uri, name, qualified, attributes);
  }

  @Override
  public void endElement(String uri, String name, String qualified) throws SAXException {
    depth--;
    super.endElement(uri, name, qualified);
  }

  /** Unlike the library's own, looks at no cause of a fault. */
  @Override
  protected void addResult(Object result) throws SAXException {
    if (isSuccess()) {
      setResult(result);
    } else if (result instanceof Map<?, ?> members
        && members.get("faultCode") instanceof Integer code
        && members.get("faultString") instanceof String text) {
      fault = Optional.of(new XmlRpcFault(code, text));
    } else {
      throw new SAXException(text("aFaultWithoutNumberAndText"));
    }
  }

  /**
   * What the server answered.
   *
   * @throws XmlRpcFault when that was a fault
   */
  Object answer() throws XmlRpcException {
    if (fault.isPresent()) {
      throw fault.get();
    }
    return getResult();
  }
}
