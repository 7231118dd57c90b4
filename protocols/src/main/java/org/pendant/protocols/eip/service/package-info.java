/**
 * Assembly configuration by XML-RPC: the service for assemblies of EtherNet/IP (manual 21.1). Open
 * {@link org.pendant.protocols.eip.service.AssemblyService} first.
 */
package org.pendant.protocols.eip.service;
