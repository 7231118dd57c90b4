/**
 * XML-RPC: remote procedure calls of scripts. Open {@link
 * org.pendant.protocols.xmlrpc.XmlRpcConnector} first. The library writes and reads the XML; what
 * servers send is bounded and never becomes a Java object of their choice.
 */
package org.pendant.protocols.xmlrpc;
