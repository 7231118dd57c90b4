/**
 * The XML-RPC service that configures assemblies of EtherNet/IP (manual 21.1). Open {@link
 * org.pendant.protocols.eip.service.AssemblyService} first.
 */
package org.pendant.protocols.eip.service;
