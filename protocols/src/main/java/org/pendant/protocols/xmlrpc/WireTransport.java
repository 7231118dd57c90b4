package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UnsupportedEncodingException;
import org.apache.xmlrpc.XmlRpcException;
import org.apache.xmlrpc.client.XmlRpcClient;
import org.apache.xmlrpc.client.XmlRpcStreamTransport;
import org.apache.xmlrpc.common.XmlRpcStreamRequestConfig;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.XMLReader;

/**
 * Wire transport: the library's path to a server, by our connection and with our parser: the
 * library's own would make a Java object of a fault's cause (CVE-2019-17570) and load what a
 * document type names (CVE-2016-5002).
 */
final class WireTransport extends XmlRpcStreamTransport {
  private final Wire wire;
  private byte[] answer = {};

  WireTransport(XmlRpcClient client, Wire wire) {
    super(client);
    this.wire = wire;
  }

  @Override
  protected void writeRequest(ReqWriter writer) throws XmlRpcException, IOException, SAXException {
    ByteArrayOutputStream call = new ByteArrayOutputStream();
    writer.write(call);
    answer = wire.exchange(call.toByteArray());
  }

  @Override
  protected InputStream getInputStream() {
    return new ByteArrayInputStream(answer);
  }

  @Override
  protected boolean isResponseGzipCompressed(XmlRpcStreamRequestConfig config) {
    return false;
  }

  /** The connection is kept. */
  @Override
  protected void close() {}

  @Override
  protected XMLReader newXMLReader() throws XmlRpcException {
    return SafeXml.reader();
  }

  @Override
  protected Object readResponse(XmlRpcStreamRequestConfig config, InputStream in)
      throws XmlRpcException {
    AnswerParser parser = new AnswerParser(config, getClient().getTypeFactory());
    XMLReader reader = newXMLReader();
    reader.setContentHandler(parser);
    try {
      reader.parse(new InputSource(in));
    } catch (UnsupportedEncodingException e) {
      // Not as an IOException: of those the caller tells the cause, here a mere name.
      throw new XmlRpcException(text("unknownEncoding", e.getMessage()), new SAXException(e));
    } catch (IOException | SAXException e) {
      throw new XmlRpcException(text("answerNotXmlRpc", e.getMessage()), e);
    }
    return parser.answer();
  }
}
