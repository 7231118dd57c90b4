package org.pendant.protocols.xmlrpc;

import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import org.apache.ws.commons.serialize.XMLWriterImpl;
import org.apache.xmlrpc.client.XmlRpcClient;
import org.apache.xmlrpc.common.XmlRpcHttpRequestConfigImpl;
import org.apache.xmlrpc.serializer.XmlRpcWriter;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.xml.sax.SAXException;

/** Call answer: what a server of ours sends back, and the values of scripts in a call. */
public final class CallAnswer {
  private CallAnswer() {}

  /**
   * The parameters of a call as scripts have them.
   *
   * @throws ScriptError for one of a type that scripts do not have
   */
  public static List<Value> parameters(CallReader.Call call) throws ScriptError {
    List<Value> values = new ArrayList<>();
    for (Object each : call.parameters()) {
      values.add(ValueXml.fromXml(each));
    }
    return values;
  }

  /**
   * The XML of an answer.
   *
   * @throws ScriptError when XML-RPC has no type for the value
   */
  public static String of(Value value) throws ScriptError {
    Object result = ValueXml.toXml(value);
    return written((writer, config) -> writer.write(config, result));
  }

  /** The XML of a refusal. */
  public static String fault(int code, String text) {
    return written((writer, config) -> writer.write(config, code, text));
  }

  /** Writes an answer. */
  @FunctionalInterface
  private interface Writing {
    void write(XmlRpcWriter writer, XmlRpcHttpRequestConfigImpl config) throws SAXException;
  }

  private static String written(Writing writing) {
    StringWriter text = new StringWriter();
    XMLWriterImpl xml = new XMLWriterImpl();
    xml.setEncoding("UTF-8");
    xml.setWriter(text);
    XmlRpcHttpRequestConfigImpl config = new XmlRpcHttpRequestConfigImpl();
    try {
      writing.write(new XmlRpcWriter(config, xml, new ScriptTypes(new XmlRpcClient())), config);
    } catch (SAXException e) {
      throw new IllegalStateException("the answer cannot be written", e);
    }
    return text.toString();
  }
}
